// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A rule: one thing that can be wrong with a model, in one file. Those on conversions and simulations are
// rows of tables (fact_row.h).
//
// `lib/rigor/rules/<category>/<rule-name>.cc` defines, in a namespace of its own, a function `rule()`
// that returns the metadata, the prose and the check. Its examples lie beside it, in the folder
// `<rule-name>/` (example.h). CMake finds both and puts them into the library; tests, `rigor explain`,
// the documentation and SARIF's help all come from them. See CONTRIBUTING.md, "How to add a rule".
//
//   namespace rigor::rules::axis_zero {
//   void check(const model::Joint& joint, Context& context) {
//     for (const model::Axis& axis : joint.axes) {
//       if (length(axis.xyz.value) > 0) continue;
//       context.report({.where = axis.xyz.span, .message = "axis is 0 0 0: it has no direction",
//                       .subject = context.subject(joint)});
//     }
//   }
//   Rule rule() { return {.name = "axis-zero", …, .checks = {on<model::Joint>(check)}}; }
//   }

#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/rules/compat.h>
#include <rigor/rules/context.h>
#include <rigor/rules/target.h>
#include <rigor/text/diagnostic.h>

// Facts that lower rooms find. Only a rule that turns a kind of them into words includes their header, so
// that a new kind is compiled into those rules and no others.
namespace rigor::xml {
struct Fault;
enum class FaultKind : std::uint8_t;
}  // namespace rigor::xml
namespace rigor::read {
struct SchemaFact;
enum class SchemaFactKind : std::uint8_t;
struct Fact;
enum class FactKind : std::uint8_t;
struct ConfigFact;
enum class ConfigFactKind : std::uint8_t;
struct MjcfFact;
enum class MjcfFactKind : std::uint8_t;
}  // namespace rigor::read
namespace rigor::xacro {
struct Fact;
enum class FactKind : std::uint8_t;
}  // namespace rigor::xacro
namespace rigor::mass {
struct MeshFacts;
}  // namespace rigor::mass
namespace rigor::convert {
struct Note;
enum class NoteKind : std::uint8_t;
}  // namespace rigor::convert
namespace rigor::simulate {
struct Fact;
enum class FactKind : std::uint8_t;
}  // namespace rigor::simulate

namespace rigor::rules {

struct SuppressionFact;
enum class SuppressionFactKind : std::uint8_t;

enum class Category : std::uint8_t {
  kXml,
  kSchema,
  kNaming,
  kReference,
  kFrame,
  kInertia,
  kKinematics,
  kGeometry,
  kMesh,
  kPhysics,
  kWorld,
  kPlugin,
  kSensor,
  kPackage,
  kConvert,
  kSimulate,
  kSuppression,
  kXacro,
  kAssembly,
  kMjcf,
};

/// Also the name of the rule's folder.
std::string_view to_string(Category category);

/// What the fixes of a rule are, if it has any.
enum class FixGrade : std::uint8_t { kNone, kSafe, kUnsafe };

/// In which files a rule looks.
enum class Formats : std::uint8_t { kAny, kSdf, kUrdf, kModelConfig, kMjcf };

/// A mesh used by a collision or visual.
struct MeshUse {
  const model::Mesh& mesh;
  const model::Geometry& geometry;
  std::string subject;
  bool collision;
  bool painted;  ///< whether the visual has a `<material>` of its own
};

/// A mesh file, by itself or as a model places it. Of several uses with the same role and scale the
/// first is asked: what is wrong with a file is reported once.
struct MeshFile {
  const mass::MeshFacts& facts;
  const MeshUse* use = nullptr;  ///< null when the file is checked by itself

  /// The URI that names it; nowhere for the file itself.
  Span where() const { return use ? use->mesh.uri.span : Span{}; }
  model::Vector3 scale() const { return use ? use->mesh.scale.value : model::Vector3{1, 1, 1}; }
  bool visual() const { return use && !use->collision; }
  bool collision() const { return use && use->collision; }
  std::string subject() const { return use ? use->subject : std::string(); }
};

template <class T>
using CheckOf = void (*)(const T&, Context&);

/// The kinds of facts that a check is for. They lie in it, so that no rule needs the heap for them.
template <class Kind>
class KindList {
 public:
  /// Throws std::out_of_range when there are more than it can hold: the rules are part of the program.
  KindList(std::initializer_list<Kind> kinds) {
    for (const Kind kind : kinds) add(kind);
  }
  void add(Kind kind) { kinds_.at(size_++) = kind; }

  const Kind* begin() const { return kinds_.data(); }
  const Kind* end() const { return kinds_.data() + size_; }

 private:
  std::array<Kind, 14> kinds_{};
  std::uint8_t size_ = 0;
};

/// A check of facts that a lower floor found, for the kinds it names.
template <class Fact, class Kind>
struct FactCheck {
  KindList<Kind> kinds;
  CheckOf<Fact> check;
};

using Check = std::variant<
    FactCheck<xml::Fault, xml::FaultKind>, FactCheck<xacro::Fact, xacro::FactKind>,
    FactCheck<read::SchemaFact, read::SchemaFactKind>, FactCheck<read::Fact, read::FactKind>,
    FactCheck<model::FrameProblem, model::FrameProblemKind>,
    FactCheck<read::ConfigFact, read::ConfigFactKind>,
    FactCheck<read::MjcfFact, read::MjcfFactKind>, FactCheck<convert::Note, convert::NoteKind>,
    FactCheck<simulate::Fact, simulate::FactKind>, FactCheck<SuppressionFact, SuppressionFactKind>,
    CheckOf<model::Root>, CheckOf<model::World>, CheckOf<model::Model>, CheckOf<model::Link>,
    CheckOf<model::Joint>, CheckOf<model::Frame>, CheckOf<model::Collision>, CheckOf<model::Visual>,
    CheckOf<model::Sensor>, CheckOf<model::Light>, CheckOf<model::Plugin>, CheckOf<model::Include>,
    CheckOf<model::Physics>, CheckOf<model::GazeboBlock>, CheckOf<model::ControlledJoint>,
    CheckOf<MeshUse>, CheckOf<MeshFile>>;

/// The check of every entity of type T that the file itself holds.
template <class T>
Check on(CheckOf<T> check) {
  return check;
}

/// The check of every fact of these kinds.
inline Check on_xml(KindList<xml::FaultKind> kinds, CheckOf<xml::Fault> check) {
  return FactCheck<xml::Fault, xml::FaultKind>{kinds, check};
}
inline Check on_xacro(KindList<xacro::FactKind> kinds, CheckOf<xacro::Fact> check) {
  return FactCheck<xacro::Fact, xacro::FactKind>{kinds, check};
}
inline Check on_schema(KindList<read::SchemaFactKind> kinds, CheckOf<read::SchemaFact> check) {
  return FactCheck<read::SchemaFact, read::SchemaFactKind>{kinds, check};
}
inline Check on_read(KindList<read::FactKind> kinds, CheckOf<read::Fact> check) {
  return FactCheck<read::Fact, read::FactKind>{kinds, check};
}
inline Check on_frames(KindList<model::FrameProblemKind> kinds,
                       CheckOf<model::FrameProblem> check) {
  return FactCheck<model::FrameProblem, model::FrameProblemKind>{kinds, check};
}
inline Check on_config(KindList<read::ConfigFactKind> kinds, CheckOf<read::ConfigFact> check) {
  return FactCheck<read::ConfigFact, read::ConfigFactKind>{kinds, check};
}
inline Check on_mjcf(KindList<read::MjcfFactKind> kinds, CheckOf<read::MjcfFact> check) {
  return FactCheck<read::MjcfFact, read::MjcfFactKind>{kinds, check};
}
inline Check on_suppression(KindList<SuppressionFactKind> kinds, CheckOf<SuppressionFact> check) {
  return FactCheck<SuppressionFact, SuppressionFactKind>{kinds, check};
}

struct Rule {
  std::string_view name;               ///< kebab-case; states the defect; also the file's name
  Category category = Category::kXml;  ///< of its folder; the registry sets it
  Severity severity = Severity::kError;
  Refusals refused = {};  ///< whether libsdformat refuses a file for it
  Formats formats = Formats::kAny;
  FixGrade fix = FixGrade::kNone;
  /// Consumers that the finding is about: the rule runs only when one of them is asked for, or the rule
  /// itself is selected, or `--compat` asks what libsdformat refuses and it does. None: it always does.
  Targets targets = {};
  std::string_view since = "0.1.0";
  std::string_view summary;     ///< one line: what is wrong
  std::string_view why;         ///< what a consumer does with it; which ones
  std::string_view what_to_do;  ///< how to put it right
  std::vector<Check> checks;
};

/// Whether some of what the rule finds is known only when meshes are opened: what they enclose, and what is
/// wrong with them.
bool needs_meshes(const Rule& rule);

}  // namespace rigor::rules
