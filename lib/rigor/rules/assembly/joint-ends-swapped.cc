// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

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

void check_wheel(const model::Joint& joint, Context& context) {
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

/// How many joints have the link as their child.
std::size_t carriers_of(model::Id<model::Link> link, Context& context) {
  std::size_t count = 0;
  for (std::uint32_t j = 0; j < context.root().joints.size(); ++j)
    count += context.frames().ends({j}).child == link ? 1 : 0;
  return count;
}

/// Whether the parent is a second root, and carries only a link that another one carries, too, or that is
/// the model's first and carries others.
// base_footprint, base_link (REP 105, REP 120): what a robot is placed by may well be its root.
bool is_base(std::string_view name) {
  for (const std::string_view word : {"base", "footprint", "root", "world", "dummy"})
    if (name.find(word) != std::string_view::npos) return true;
  return false;
}

bool hangs_on_its_child(model::Id<model::Joint> id, Context& context) {
  const model::Root& root = context.root();
  const auto& ends = context.frames().ends(id);
  const model::Id<model::Model> model = root[ends.parent].model;
  if (!model || root[ends.child].model != model || !root.own(root[model].site)) return false;
  const auto& links = root[model].links;
  constexpr std::size_t kFewestLinks = 3;
  if (links.size() < kFewestLinks || links.front() == ends.parent) return false;
  if (context.assembled().links[ends.parent.value].carrier) return false;
  // A frame that the robot is placed by: world, map.
  const model::Link& parent = root[ends.parent];
  if (parent.visuals.empty() && parent.collisions.empty() && !parent.inertial.written) return false;
  if (carries_others(ends.parent, id, context)) return false;
  if (carriers_of(ends.child, context) > 1) return true;
  return links.front() == ends.child && !is_base(parent.name.value) &&
         carries_others(ends.child, id, context);
}

void check(const model::Joint& joint, Context& context) {
  const model::Root& root = context.root();
  const model::Id<model::Joint> id{static_cast<std::uint32_t>(&joint - root.joints.data())};
  const auto& ends = context.frames().ends(id);
  if (!ends.parent || !ends.child || !hangs_on_its_child(id, context)) {
    check_wheel(joint, context);
    return;
  }
  context.report(
      {.where = joint.child.span,
       .message = fmt::format(
           "parent '{}' is carried by nothing and carries nothing else, and child "
           "'{}' {}: they are exchanged",
           joint.parent.value, joint.child.value,
           carriers_of(ends.child, context) > 1 ? "has two parents" : "is the robot's first link"),
       .subject = context.subject(joint),
       .related = {{joint.parent.span, "the parent"}},
       .fix = swap("exchange parent and child", joint.parent.span, joint.child.span, context)});
}

Rule rule() {
  return {
      .name = "joint-ends-swapped",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "parent and child of a joint are exchanged",
      .why =
          "The robot hangs on its part: a wheel swings about the robot's middle, or the robot "
          "about it, as an SDF joint is "
          "where its child is. The parent is round about the joint's axis where it is itself, "
          "carries nothing else and is carried by nothing, while the child carries other links; or "
          "it is a second root of the robot, and the child has another parent or is the "
          "robot's first link.",
      .what_to_do = "Exchange <parent> and <child>.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::joint_ends_swapped
