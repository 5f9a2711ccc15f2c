// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What both targets share: which bodies of an MJCF file become links, by which names, and what couples joints.
// Private to the room.
//
//   MjcfPlan plan(source, options, MjcfTarget::kSdf);
//   if (!plan.refusals.empty()) return;

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <rigor/convert/from_mjcf.h>
#include <rigor/model/unique_names.h>
#include <rigor/read/mjcf/mjcf_scope.h>

namespace rigor::convert {

enum class MjcfTarget : std::uint8_t { kUrdf, kSdf };

/// A `connect` or `weld`, or two of them on one axis: a joint that closes a loop.
struct MjcfLoop {
  std::string name;
  model::JointType type = model::JointType::kFixed;
  std::uint32_t parent = robot::kNoIndex, child = robot::kNoIndex;  ///< bodies
  model::Pose X_PJ, X_CJ;                                           ///< in the bodies' own frames
  model::Vector3 axis;  ///< unit vector of a revolute one, in the joint frame
  std::vector<xml::Element> elements;
};

struct MjcfPlan {
  MjcfPlan(const FromMjcfSource& source, const FromMjcfOptions& options, MjcfTarget target);

  const model::Root& root() const { return source.source.root; }
  const model::Link& link(std::uint32_t body) const { return root().links[body]; }
  /// Whether a joint carries it; a body without one is free, or the world.
  bool is_carried(std::uint32_t body) const {
    return robot.bodies[body].carrier != robot::kNoIndex;
  }
  std::uint32_t parent_of(std::uint32_t body) const {
    return robot.joints[robot.bodies[body].carrier].parent;
  }
  bool is_between(std::uint32_t body) const {
    return body < root().links.size() && link(body).between_joints;
  }
  std::string unique(model::UniqueNames& taken, const std::string& name) const;
  /// By its name in the file; of a joint, of the robot's.
  std::optional<std::uint32_t> body_named(const std::string& name) const;
  std::optional<std::uint32_t> joint_named(const std::string& name) const;
  /// In the body that carries it, which may be one that is not converted.
  std::optional<model::Pose> site_pose(const std::string& name, std::uint32_t& body) const;

  const FromMjcfSource& source;
  const FromMjcfOptions& options;
  MjcfTarget target;
  read::MjcfFacts facts;  ///< told when the file is checked
  read::MjcfScope scope;
  Notes refusals;

  /// As the file has it, with joints that an equality holds in place locked there, and with a name for each
  /// shape that its link in the result has once. Bodies are in the order of the root's links, then the world
  /// where it has no link; their shapes are in the order of the link's.
  robot::Robot robot;
  std::vector<model::Id<model::Joint>> joint_ids;                  ///< of the robot's joints
  std::vector<std::optional<model::Id<model::Joint>>> free_joint;  ///< of each body
  std::uint32_t world = robot::kNoIndex;
  std::vector<bool> chosen;                      ///< bodies that are converted, the world aside
  bool shows_world = false;                      ///< whether the shapes of the world are converted
  bool is_static = false;                        ///< SDF: whether nothing of it ever moves
  std::vector<std::string> link_names;           ///< in the result, by body
  std::vector<std::string> joint_names;          ///< in the result, by joint of the robot
  model::UniqueNames taken_links, taken_joints;  ///< one set in SDF: `taken_links`
  std::vector<MjcfLoop> loops;
  std::vector<xml::Element> locks;  ///< equalities that hold a joint in place

 private:
  /// Files that hold bodies and do not exist.
  void refuse_missing_files();
  void choose();
  void settle_balls();
  void name_all();
  void name_parts();
  void find_locks();
  void find_loops();
  std::uint32_t root_of(std::uint32_t body) const;
  std::unordered_map<std::string, std::uint32_t> body_index_, joint_index_, site_index_;
};

/// The text of an attribute; empty where it is not written.
std::string mjcf_word(xml::Element element, std::string_view attribute);

/// The name of the SDF link that holds the shapes of the world.
inline constexpr std::string_view kSurroundings = "surroundings";

/// Opens the file, what it includes and what it attaches, and takes what the result says in its own words.
void take_mjcf_source(const MjcfPlan& plan, Ledger& ledger);

/// The note for an element that no code took.
NoteKind mjcf_source_kind(xml::Element element);

/// The account, with paths in notes cut to the element and its attribute.
Account close_mjcf_account(Ledger ledger);

/// The robot that the result should be, its loops aside: what was chosen, without what the target has no
/// place for.
robot::Robot expected_robot(const MjcfPlan& plan);

/// `Builder` makes the model of a target: `Builder(plan, ledger, result).build()`.
template <class Builder>
FromMjcfConversion converted_from_mjcf(const MjcfPlan& plan) {
  FromMjcfConversion result;
  result.model = {0};
  result.account.notes = plan.refusals;
  if (!plan.refusals.empty()) return result;
  Ledger ledger(plan.source.source.documents);
  take_mjcf_source(plan, ledger);
  Builder(plan, ledger, result).build();
  result.robot = expected_robot(plan);
  result.account = close_mjcf_account(std::move(ledger));
  return result;
}

}  // namespace rigor::convert
