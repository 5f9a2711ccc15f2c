// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene while it is made. Private to the room; each file of `build_*.cc` adds its part.

#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/simulate/scene/build.h>
#include <rigor/xml/document.h>

namespace rigor::simulate {

/// Farther and larger things are refused: at 1000 km a double still tells nanometers apart, and ODE
/// ends the process at 10¹² m.
inline constexpr double kFarthest = 1e6;  // m

/// URDF's `<gazebo reference="…">` blocks, by the robot that they stand in.
class GazeboBlocks {
 public:
  explicit GazeboBlocks(const model::Root& root);

  /// Their children of these names, in document order; an empty reference refers to the robot.
  std::vector<const model::Parameter*> find(const model::Model& robot, const std::string& reference,
                                            std::initializer_list<std::string_view> names) const;

 private:
  using Key = std::pair<Span, std::string>;
  struct Less {
    bool operator()(const Key& a, const Key& b) const;
  };
  std::map<Key, std::vector<const model::GazeboBlock*>, Less> blocks_;
};

struct SceneDraft {
  SceneDraft(const SceneInput& from, const SceneOptions& how);

  const SceneInput& input;
  const SceneOptions& options;
  const model::Root& root;
  GazeboBlocks blocks;
  Scene scene;
  Facts facts;
  std::vector<std::uint32_t> model_of;  ///< of the root's models the scene's; kWorld when left out
  std::vector<std::uint32_t> link_of;   ///< likewise of links
  std::vector<std::uint32_t> joint_of;  ///< likewise of joints
  std::vector<bool> is_static;          ///< of the root's models

  /// What of surfaces is said to be ignored, of which model.
  std::set<std::pair<std::uint32_t, std::string>> surface_words;

  bool takes(model::Id<model::Model> id) const { return id && model_of[id.value] != kWorld; }
  xml::Element element(const model::Site& site) const { return input.documents.element(site); }

  template <class Entity>
  void say(FactKind kind, Span where, const Entity& entity, std::string name = {}, double value = 0,
           double limit = 0) {
    facts.push_back({.kind = kind,
                     .where = where,
                     .subject = model::subject(root, entity),
                     .value = value,
                     .limit = limit,
                     .name = std::move(name),
                     .test = {},
                     .severe = kind <= FactKind::kTooLarge});
  }

  /// A number that is finite; else a fact with its place, and the fallback.
  template <class Entity>
  double number(const std::optional<read::Text>& text, double fallback, std::string_view name,
                const Entity& entity) {
    if (!text || read::trimmed(text->text).empty()) return fallback;
    if (const auto value = parsed_number(text->text)) return *value;
    say(FactKind::kNotFinite, text->span, entity, std::string(name));
    return fallback;
  }

  template <class Entity>
  double number(const model::Parameter& given, double fallback, const Entity& entity) {
    const read::Text text{given.value.value, given.value.span};
    return number(text, fallback, given.name, entity);
  }

  static std::optional<double> parsed_number(std::string_view text);
};

/// The element at the end of a path of names.
std::optional<xml::Element> element_at(xml::Element from,
                                       std::initializer_list<std::string_view> path);

void check_numbers(SceneDraft& draft);  // numbers.cc
void add_physics(SceneDraft& draft);    // physics.cc
void add_bodies(SceneDraft& draft);     // body.cc
void add_joints(SceneDraft& draft);     // joint.cc
void choose_bases(SceneDraft& draft);   // base.cc
void add_shapes(SceneDraft& draft);     // shape.cc

/// `<surface>` of a collision, or what the blocks of its link say.
ContactSurface surface_of(SceneDraft& draft, const model::Collision& collision);

}  // namespace rigor::simulate
