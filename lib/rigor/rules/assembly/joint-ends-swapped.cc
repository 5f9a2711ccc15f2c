// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <string>

#include <fmt/core.h>

#include <rigor/robot/assembled/axles.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::joint_ends_swapped {

using model::Vector3;

// Of the radius: a shape that is farther off the axis swings rather than rolls.
constexpr double kOffAxis = 0.2;
constexpr double kSwings = 0.5;

/// The larger the shape's middle is off a line through `from`, the less it rolls about that.
double off_axis(const Vector3& middle, const Vector3& from, const Vector3& axis_W) {
  const Vector3 arm = middle - from;
  return length(arm - dot(arm, axis_W) * axis_W);
}

/// Whether a shape of the link is round about the axis at the link's own origin, and swings about the joint.
bool belongs_to(model::Id<model::Link> link, const Vector3& joint_W, const Vector3& axis_W,
                Context& context) {
  const robot::Assembled& robot = context.assembled();
  const robot::AssembledLink& assembled = robot.links[link.value];
  if (!assembled.X_WL) return false;
  return std::any_of(assembled.shapes.begin(), assembled.shapes.end(), [&](std::uint32_t s) {
    const robot::AssembledShape& shape = robot.shapes[s];
    const model::Root& root = context.root();
    const model::Shape& of = shape.role == robot::ShapeRole::kCollision
                                 ? root.collisions[shape.index].geometry.shape
                                 : root.visuals[shape.index].geometry.shape;
    const auto radius = robot::radius_about(shape, of, axis_W);
    if (!radius) return false;
    const Vector3& middle = shape.box_W.center_W;
    return off_axis(middle, assembled.X_WL->translation, axis_W) < kOffAxis * *radius &&
           off_axis(middle, joint_W, axis_W) > kSwings * *radius;
  });
}

bool carries_others(model::Id<model::Link> link, model::Id<model::Joint> but, Context& context) {
  const model::Root& root = context.root();
  for (std::uint32_t j = 0; j < root.joints.size(); ++j) {
    if (j != but.value && context.frames().ends({j}).parent == link) return true;
  }
  return false;
}

void check(const model::Joint& joint, Context& context) {
  if (joint.axes.empty() || !robot::turns_on_and_on(joint)) return;
  const model::Root& root = context.root();
  const model::Id<model::Joint> id{static_cast<std::uint32_t>(&joint - root.joints.data())};
  const auto& ends = context.frames().ends(id);
  if (!ends.parent || !ends.child || context.assembled().links[ends.parent.value].carrier) return;
  const auto axis_W = context.frames().axis(id, 0);
  const auto X_WJ = context.frames().pose(id);
  if (!axis_W || !X_WJ || !carries_others(ends.child, id, context)) return;
  if (carries_others(ends.parent, id, context)) return;
  if (!belongs_to(ends.parent, X_WJ->translation, *axis_W, context)) return;
  context.report(
      {.where = joint.child.span,
       .message = fmt::format("parent '{}' is a wheel about this axis, and child '{}' carries the "
                              "robot's other links: they are exchanged",
                              joint.parent.value, joint.child.value),
       .subject = context.subject(joint),
       .related = {{joint.parent.span, "the wheel"}},
       .fix = swap("exchange parent and child", joint.parent.span, joint.child.span, context)});
}

Rule rule() {
  return {
      .name = "joint-ends-swapped",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "parent and child of a wheel's joint are exchanged",
      .why = "The wheel swings about the robot's middle, or the robot about it: an SDF joint is "
             "where its child is. The parent is round about the joint's axis where it is itself, "
             "carries nothing else and is carried by nothing, while the child carries other links.",
      .what_to_do = "Exchange <parent> and <child>.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::joint_ends_swapped
