// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/reroot.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/placed.h>
#include <rigor/author/verbs/robot_laws.h>

namespace rigor::author {
namespace {

using model::Id;
using model::JointType;
using model::Pose;

/// Whose motion, seen from the other side, is the same with the axis negated.
bool is_reversible(const robot::Joint& joint) {
  return joint.type == JointType::kFixed || joint.axes.size() == 1;
}

/// The law. X_BN is the new root's frame in that of its body.
robot::Robot rerooted_robot(robot::Robot robot, std::uint32_t body, const Pose& X_BN) {
  const std::vector<std::uint32_t> path = path_to_root(robot, body);
  Pose X_CN = X_BN;  // the frame of the body below, in what was its frame
  describe_in(robot, body, X_BN);
  for (const std::uint32_t i : path) {
    robot::Joint& joint = robot.joints[i];
    const Pose X_PJ = joint.X_PJ;
    describe_in(robot, joint.parent, X_PJ);
    std::swap(joint.parent, joint.child);
    joint.X_PJ = inverse(X_CN);
    X_CN = X_PJ;
    for (robot::Axis& axis : joint.axes) axis.direction = -1 * axis.direction;
  }
  robot::connect(robot);
  return robot;
}

class Rerooter {
 public:
  Rerooter(const EditedModel& edited, std::uint32_t body)
      : edited_(edited),
        root_(edited.root()),
        draft_(edited),
        body_(body),
        path_(path_to_root(edited.robot, body)) {}

  Change reroot(Id<model::Link> link) {
    if (std::string fault = fault_of_path(); !fault.empty()) return refusal(std::move(fault));
    for (const std::uint32_t i : path_) {
      const robot::Joint& joint = edited_.robot.joints[i];
      const Id<model::Joint> id = edited_.joint(joint.name);
      if (!id || !root_.own(root_[id].site))
        return refusal(fmt::format("joint '{}' is in a file that is included", joint.name));
      turned_.insert(id.value);
    }
    edited_.is_urdf() ? turn_urdf() : turn_sdf();
    Change change;
    change.refused = draft_.problem();
    change.steps = draft_.take();
    for (const std::uint32_t i : path_)
      change.notes.push_back("joint " + edited_.robot.joints[i].name + " is turned");
    const Pose X_MB = edited_.robot.bodies[body_].X_MB;
    const Pose X_ML =
        compose(inverse(*edited_.frames.pose(edited_.model)), *edited_.frames.pose(link));
    const Pose X_BN = edited_.is_urdf() ? Pose{} : compose(inverse(X_MB), X_ML);
    change.expected = rerooted_robot(edited_.robot, body_, X_BN);
    if (edited_.is_urdf()) {
      change.expected.bodies[body_].X_MB = {};
      robot::connect(change.expected);
      change.asks_for_setting = is_of_pose;
    }
    return change;
  }

 private:
  std::string fault_of_path() const {
    const robot::Robot& robot = edited_.robot;
    if (path_.empty()) return fmt::format("link '{}' is the root", robot.bodies[body_].name);
    for (const robot::Joint& joint : robot.joints) {
      if (joint.closes_loop) return fmt::format("joint '{}' closes a loop", joint.name);
    }
    for (const std::uint32_t i : path_) {
      const robot::Joint& joint = robot.joints[i];
      if (robot.bodies[joint.parent].name == robot::kWorldBody)
        return "the robot is fixed to the world";
      if (!is_reversible(joint))
        return fmt::format("joint '{}' is {} and has another motion from its other side",
                           joint.name, to_string(joint.type));
    }
    return {};
  }

  /// Frames of the links on the way are those of the joints that will carry them.
  void turn_urdf() {
    std::map<std::uint32_t, Pose> X_NB;  // by link: its old frame in its new one
    std::map<std::uint32_t, Pose> origin;
    Pose X_CN;
    for (const std::uint32_t i : path_) {
      const robot::Joint& joint = edited_.robot.joints[i];
      origin[edited_.joint(joint.name).value] = inverse(X_CN);
      X_CN = joint.X_PJ;
      X_NB[edited_.link(edited_.robot.bodies[joint.parent].name).value] = inverse(joint.X_PJ);
    }
    for (const Placed& each : placed_in(edited_)) {
      if (each.kind == PlacedKind::kJoint) {
        const model::Joint& joint = root_.joints[each.index];
        if (turned_.contains(each.index)) {
          draft_.set_pose(each.field, each.holder, origin[each.index]);
          swap_ends(joint);
          negate_axes(joint);
          continue;
        }
        const auto moved = X_NB.find(edited_.link(joint.parent.value).value);
        if (moved != X_NB.end())
          draft_.set_pose(each.field, each.holder, compose(moved->second, each.field.pose.value));
      } else if (const auto moved = X_NB.find(each.link.value);
                 moved != X_NB.end() && each.field.relative_to.value.empty()) {
        draft_.set_pose(each.field, each.holder, compose(moved->second, each.field.pose.value));
      }
    }
  }

  /// A joint that is written from its child to its parent is as it should be already.
  void turn_sdf() {
    for (const std::uint32_t i : path_) {
      const robot::Joint& turned = edited_.robot.joints[i];
      const Id<model::Joint> id = edited_.joint(turned.name);
      const model::Joint& joint = root_[id];
      const auto& ends = edited_.frames.ends(id);
      if (!ends.parent || edited_.name_of(ends.parent) != edited_.robot.bodies[turned.parent].name)
        continue;
      swap_ends(joint);
      negate_axes(joint);
      if (!joint.pose.relative_to.value.empty()) continue;
      const xml::Element element = edited_.element(joint.site);
      if (root_[joint.model].version >= 7) {
        draft_.set_pose(joint.pose, element, joint.pose.pose.value, joint.child.value);
      } else {
        draft_.set_pose(
            joint.pose, element,
            compose(inverse(*edited_.frames.pose(ends.parent)), *edited_.frames.pose(id)));
      }
    }
  }

  void swap_ends(const model::Joint& joint) {
    draft_.add({{joint.parent.span, std::string(edited_.sources.bytes(joint.child.span))}});
    draft_.add({{joint.child.span, std::string(edited_.sources.bytes(joint.parent.span))}});
  }

  void negate_axes(const model::Joint& joint) {
    if (joint.type == JointType::kFixed || joint.type == JointType::kFloating) return;
    for (const model::Axis& axis : joint.axes) draft_.set_axis(joint, axis, -1 * axis.xyz.value);
  }

  const EditedModel& edited_;
  const model::Root& root_;
  Draft draft_;
  std::uint32_t body_;
  std::vector<std::uint32_t> path_;
  std::set<std::uint32_t> turned_;  ///< joints of the root
};

}  // namespace

Change rerooted(const EditedModel& edited, std::string_view link) {
  const std::uint32_t body = edited.body_index(link);
  const Id<model::Link> id = edited.link(link);
  if (body == robot::kNoIndex || !id) return refusal(fmt::format("no link is named '{}'", link));
  return Rerooter(edited, body).reroot(id);
}

}  // namespace rigor::author
