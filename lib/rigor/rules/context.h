// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a rule may ask while it checks, and how it says what it found.
//
//   context.report({.where = joint.type_name.span, .message = "…", .subject = context.subject(joint)});

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/rules/compat.h>
#include <rigor/rules/page_in_brief.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>
#include <rigor/xml/document.h>

// What rules ask for and few of them do: who asks includes its header.
namespace rigor {
class Disk;
}  // namespace rigor
namespace rigor::schema {
class Schema;
}  // namespace rigor::schema
namespace rigor::read {
struct Resolution;
class Resolver;
}  // namespace rigor::read
namespace rigor::mass {
enum class From : std::uint8_t;
struct LinkBody;
class MeshFiles;
struct MeshSurvey;
class MeshSurveys;
struct Verdict;
}  // namespace rigor::mass
namespace rigor::mesh {
struct Bounds;
}  // namespace rigor::mesh
namespace rigor::robot {
struct Assembled;
enum class ShapeRole : std::uint8_t;
}  // namespace rigor::robot

namespace rigor::rules {

struct NameScope;
struct SdformatRobot;
struct Uri;

/// What a rule says; its name, category and severity are added for it.
struct Finding {
  Span where;
  std::string message;
  std::string of_file = {};  ///< whose content the message quotes, where that is another file
  bool measured =
      false;  ///< whether it tells numbers of the mesh only, and none of its file's text
  std::string subject = {};  ///< when empty, what the elements around the place are called
  std::vector<Label> related = {};
  std::string help = {};
  std::optional<Fix> fix = std::nullopt;
  bool refused =
      false;  ///< whether libsdformat refuses the file for it, where the rule leaves that open
  /// What it has in common with other findings of the rule: a URI, a missing package, a misspelt name. When
  /// empty, the message, with the subject's own names taken out.
  std::string cause = {};
  std::string why =
      {};  ///< what a consumer makes of this case; when empty, the rule's page says it
  /// Where the effect of this one is larger or smaller than that of most; else the rule's severity.
  std::optional<Severity> severity = std::nullopt;
};

class Context {
 public:
  struct Inputs {
    std::string path;  ///< of the file that is checked
    const Sources& sources;
    /// Null only when the file could not be read; then no entity and no fact needs it.
    const xml::Document* document;
    const model::Root& root;
    const model::Frames& frames;
    const read::Resolver& resolver;
    const schema::Schema* schema;  ///< of the file's format; null when it has none
    const schema::Schema& sdf;
    mass::MeshSurveys* meshes;  ///< null when meshes are not to be opened
    mass::MeshFiles* files;     ///< likewise
    std::size_t max_listed;     ///< findings of one rule
  };

  /// Both outlive it.
  Context(const Inputs& inputs, Diagnostics& diagnostics);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Lists the first `max_listed` causes of a rule, each with its places up to ten times as many in all,
  /// and counts the others. Of what was left for xacro only
  /// that is reported. What a rule says of a mesh file is reported once, however many shapes use it.
  void report(Finding finding);
  /// Says how many findings of each rule were counted only; when all checks are done.
  void report_counted();

  /// Whether a finding may still come with a suggestion. Each compares a name with all that there
  /// are, and whoever has thousands of wrong ones needs no help with their spelling.
  bool may_suggest() const { return compared_ < kMaxCompared; }
  void compared(std::size_t names) { compared_ += names; }

  const Sources& sources() const { return inputs_.sources; }
  const xml::Document& document() const { return *inputs_.document; }
  const model::Root& root() const { return inputs_.root; }
  const model::Frames& frames() const { return inputs_.frames; }
  const schema::Schema* schema() const { return inputs_.schema; }
  /// Of SDF, whatever the file's format.
  const schema::Schema& sdf_schema() const { return inputs_.sdf; }
  bool is_urdf() const { return inputs_.root.format == model::Format::kUrdf; }
  bool is_mjcf() const { return inputs_.root.format == model::Format::kMjcf; }
  bool is_sdf() const { return inputs_.root.format == model::Format::kSdf; }

  /// Of the file that is checked, and from which URIs are resolved.
  const std::string& path() const { return inputs_.path; }

  /// The bytes a span represents, as written.
  std::string_view bytes(Span span) const { return inputs_.sources.bytes(span); }

  /// The element an entity was read from. Only for entities of the file itself.
  xml::Element element(const model::Site& site) const {
    return inputs_.document->element(site.element);
  }

  /// Where a URI that stands in this file leads. Looked up once, however many rules ask.
  const read::Resolution& resolve(const std::string& uri);
  const Disk& disk() const;
  const read::Resolver& resolver() const { return inputs_.resolver; }
  /// Those that may name another file, as `package/assets.h` has them. Collected once.
  const std::vector<xml::Element>& elements_about_files();
  /// The URIs that stand in the file. Collected once.
  const std::vector<Uri>& uris();
  /// The scopes of the file in which some name repeats. Collected once.
  const std::vector<NameScope>& repeated_names();
  /// What libsdformat makes of a URDF robot. Found once.
  const SdformatRobot& sdformat_robot();

  /// Whether meshes, and other files that are made of triangles, may be opened.
  bool opens_meshes() const { return inputs_.files != nullptr; }
  /// What the mesh's triangles enclose; null when its file is not found, or meshes are not opened.
  const mass::MeshSurvey* survey(const model::Mesh& mesh);
  /// The link's shapes as solids. Computed once, however many rules ask.
  const mass::LinkBody& body(const model::Link& link, mass::From from);
  /// The file's models as they stand assembled, all joints at zero. Put together once.
  const robot::Assembled& assembled();
  /// What is possible of the tensor that the link's inertial has, written or not. Judged once.
  const mass::Verdict& verdict(const model::Link& link);

  /// The folder of the file that is checked.
  std::string_view folder() const;

  /// "arm/joint elbow", "arm::hand/link palm/collision box": the model's scoped name, then kinds and
  /// names inward.
  std::string subject(const model::World& world) const;
  std::string subject(const model::Model& model) const;
  std::string subject(const model::Link& link) const;
  std::string subject(const model::Joint& joint) const;
  std::string subject(const model::Frame& frame) const;
  std::string subject(const model::Collision& collision) const;
  std::string subject(const model::Visual& visual) const;
  std::string subject(const model::Sensor& sensor) const;
  std::string subject(const model::Light& light) const;
  std::string subject(const model::Plugin& plugin) const;

  /// The mesh file that rules are looking at; set by the runner.
  void begin_mesh(const std::string& path) { mesh_ = path; }
  void end_mesh() { mesh_.clear(); }

  /// The rule that is at work; set by the runner.
  void begin_rule(std::string_view name, std::string_view category, Severity severity,
                  PageProse prose = {}) {
    rule_ = name;
    category_ = category;
    prose_ = prose;
    page_.reset();
    severity_ = severity;
    graded_ = true;
    refusal_.reset();
  }
  /// Gives all its findings the severity of the rule, which the user has set.
  void hold_severity() { graded_ = false; }
  /// Makes its findings errors if libsdformat refuses files for them, and else warnings at most.
  void judge_by(Refusal refusal) { refusal_ = refusal; }

 private:
  struct Found;  ///< what was asked for so far, and what each rule reported

  std::optional<mesh::Bounds> bounds(const model::Mesh& mesh, robot::ShapeRole role);
  Diagnostic diagnostic_of(const Finding& finding);
  void list_or_count(Diagnostic diagnostic);
  Severity severity_of(const Finding& finding) const;
  std::string subject_at(Span where) const;
  Span written(Span where) const;

  /// Names compared for suggestions in one file: a tenth of a second.
  static constexpr std::size_t kMaxCompared = 300'000;

  const Inputs& inputs_;
  Diagnostics& diagnostics_;
  std::unique_ptr<Found> found_;
  std::size_t compared_ = 0;
  std::string mesh_;  // empty when none is examined
  std::string_view rule_;
  std::string_view category_;
  PageProse prose_;
  std::optional<PageInBrief> page_;  // made of the prose when the rule finds something
  Severity severity_ = Severity::kError;
  bool graded_ = true;              // whether a finding may have a severity of its own
  std::optional<Refusal> refusal_;  // nothing when rigor's own judgment counts
};

}  // namespace rigor::rules
