// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/move_frame.h>

#include <string>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/placed.h>
#include <rigor/author/verbs/robot_laws.h>
#include <rigor/mass/resolve.h>

namespace rigor::author {
namespace {

using model::Id;
using model::Pose;

/// A frame this far off a joint's axis is on it, m: what rounding leaves of meters.
constexpr double kOnAxis = 1e-12;

class FrameMover {
 public:
  FrameMover(const EditedModel& edited, Id<model::Link> link, std::uint32_t body, const Pose& X_LN)
      : edited_(edited),
        root_(edited.root()),
        draft_(edited),
        link_(link),
        body_(body),
        X_LN_(X_LN),
        X_NL_(inverse(X_LN)) {}

  Change move() {
    if (!root_.own(root_[link_].site)) return refusal("the link is in a file that is included");
    if (mass::resolve(root_, edited_.frames, link_, edited_.find_mesh).taken ==
        mass::Taken::kAutomaticUnknown)
      return refusal("the link's mass cannot be computed, so not placed");
    const std::uint32_t carrier = edited_.robot.bodies[body_].carrier;
    const robot::Joint* joint =
        carrier == robot::kNoIndex ? nullptr : &edited_.robot.joints[carrier];
    if (edited_.is_urdf() && joint != nullptr) {
      if (std::string fault = fault_of(*joint); !fault.empty()) return refusal(std::move(fault));
    }
    for (const Placed& each : placed_in(edited_)) place(each);
    rewrite_axes(joint);
    Change change;
    if (has_default_mass()) {
      change.notes.push_back(
          fmt::format("link {} has no <inertial>: the 1 kg that SDF defaults to is at its frame, "
                      "and moves with it",
                      edited_.name_of(link_)));
    }
    change.refused = draft_.problem();
    change.steps = draft_.take();
    change.expected = expected(carrier);
    change.asks_for_setting = is_of_pose;
    return change;
  }

 private:
  /// The URDF joint's motion is about a line through the link's frame.
  std::string fault_of(const robot::Joint& joint) const {
    if (joint.type == model::JointType::kFixed || joint.type == model::JointType::kPrismatic)
      return {};
    if (joint.closes_loop || joint.axes.size() != 1)
      return fmt::format("joint '{}' would move about another point", joint.name);
    if (length(cross(joint.axes[0].direction, X_LN_.translation)) <= kOnAxis) return {};
    return fmt::format("the frame would leave the axis of joint '{}'", joint.name);
  }

  bool is_link(Id<model::Model> scope, const std::string& name) const {
    const model::Named found = edited_.frames.names().find({scope, {}}, name);
    const auto* link = std::get_if<Id<model::Link>>(&found);
    return link != nullptr && *link == link_;
  }

  bool is_in_link(const Placed& each) const {
    if (each.kind == PlacedKind::kInertial) return each.link == link_;  // whatever it names
    const std::string& name = each.field.relative_to.value;
    if (!name.empty()) return is_link(each.scope, name);
    switch (each.kind) {
      case PlacedKind::kModel:
      case PlacedKind::kInclude:
      case PlacedKind::kLink: return false;
      case PlacedKind::kJoint: {
        const model::Joint& joint = root_.joints[each.index];
        return is_link(each.scope, edited_.is_urdf() ? joint.parent.value : joint.child.value);
      }
      case PlacedKind::kFrame:
        return is_link(each.scope, root_.frames[each.index].attached_to.value);
      default: return each.link == link_ && !each.on_joint;
    }
  }

  void place(const Placed& each) {
    const Pose& X = each.field.pose.value;
    if (each.kind == PlacedKind::kLink && each.index == link_.value) {
      draft_.set_pose(each.field, each.holder, compose(X, X_LN_));
    } else if (edited_.is_urdf() && each.kind == PlacedKind::kJoint && each.link == link_) {
      draft_.set_pose(each.field, each.holder, compose(X, X_LN_));
    } else if (is_in_link(each)) {
      draft_.set_pose(each.field, each.holder, compose(X_NL_, X));
    }
  }

  /// 1 kg and the identity, which SDF takes at the link's frame, wherever that is.
  bool has_default_mass() const { return !edited_.is_urdf() && !root_[link_].inertial.written; }

  Pose new_frame_in_body() const {
    const Pose X_ML =
        compose(inverse(*edited_.frames.pose(edited_.model)), *edited_.frames.pose(link_));
    return compose(inverse(edited_.robot.bodies[body_].X_MB), compose(X_ML, X_LN_));
  }

  void rewrite_axes(const robot::Joint* carrier) {
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      const model::Joint& joint = root_.joints[i];
      if (!edited_.inside(joint.model) || joint.type == model::JointType::kFixed) continue;
      const bool carries =
          edited_.is_urdf() && carrier != nullptr && joint.name.value == carrier->name;
      for (const model::Axis& axis : joint.axes) {
        const std::string& in = axis.expressed_in.value;
        if (carries || (!in.empty() && is_link(joint.model, in)))
          draft_.set_axis(joint, axis, rotate(X_NL_.rotation, axis.xyz.value));
      }
    }
  }

  robot::Robot expected(std::uint32_t carrier) const {
    robot::Robot robot = edited_.robot;
    if (carrier != robot::kNoIndex && !edited_.is_urdf()) {
      if (has_default_mass()) robot.bodies[body_].mass.com = new_frame_in_body().translation;
      return robot;
    }
    describe_in(robot, body_, X_LN_);
    if (has_default_mass()) robot.bodies[body_].mass.com = {};
    if (carrier == robot::kNoIndex) {
      if (edited_.is_urdf()) robot.bodies[body_].X_MB = {};
    } else {
      robot::Joint& joint = robot.joints[carrier];
      joint.X_PJ = compose(joint.X_PJ, X_LN_);
      for (robot::Axis& axis : joint.axes) axis.direction = rotate(X_NL_.rotation, axis.direction);
    }
    robot::connect(robot);
    return robot;
  }

  const EditedModel& edited_;
  const model::Root& root_;
  Draft draft_;
  Id<model::Link> link_;
  std::uint32_t body_;
  Pose X_LN_, X_NL_;
};

}  // namespace

std::optional<Pose> frame_at(const EditedModel& edited, std::string_view link, FramePlace place) {
  const Id<model::Link> id = edited.link(link);
  const std::uint32_t body = edited.body_index(link);
  if (!id || body == robot::kNoIndex) return std::nullopt;
  if (place == FramePlace::kCenterOfMass && !edited.root()[id].inertial.written)
    return std::nullopt;
  const Pose X_ML = compose(inverse(*edited.frames.pose(edited.model)), *edited.frames.pose(id));
  const robot::Body& carried = edited.robot.bodies[body];
  const Pose X_LB = compose(inverse(X_ML), carried.X_MB);
  if (place == FramePlace::kCenterOfMass) return Pose{transform(X_LB, carried.mass.com), {}};
  return carried.carrier == robot::kNoIndex ? std::nullopt : std::optional(X_LB);
}

Change with_frame(const EditedModel& edited, std::string_view link, const Pose& X_LN) {
  const Id<model::Link> id = edited.link(link);
  const std::uint32_t body = edited.body_index(link);
  if (!id || body == robot::kNoIndex) return refusal(fmt::format("no link is named '{}'", link));
  return FrameMover(edited, id, body, X_LN).move();
}

}  // namespace rigor::author
