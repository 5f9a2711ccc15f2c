// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/axles.h>
#include <rigor/rules/assembly/twin_numbers.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::twin_axis_differs {

using model::Vector3;

// 8°: less is camber or calibration.
constexpr double kAlong = 0.99;
// 45°: what is between may be meant.
constexpr double kAcross = 0.71;

/// How far the axes of two twins are from being parallel, or mirrored in the plane between them: the cosine
/// of the better.
double likeness_of(const Vector3& a, const Vector3& b, const Vector3& between) {
  const Vector3 n = (1 / length(between)) * between;
  const Vector3 mirrored = a - 2 * dot(a, n) * n;
  return std::max(std::abs(dot(a, b)), std::abs(dot(mirrored, b)));
}

/// Whether both joints are written alike, so that what differs is what carries them: the arms of a duo.
bool written_alike(const model::Joint& a, const model::Joint& b) {
  return a.axes.front().xyz.value == b.axes.front().xyz.value &&
         a.pose.pose.value.rotation == b.pose.pose.value.rotation;
}

struct AxisPair {
  robot::Twins joints;
  double likeness = 1;
  bool wheels = false;
};

std::optional<AxisPair> compared(const robot::Twins& pair, Context& context) {
  const model::Root& root = context.root();
  const model::Frames& frames = context.frames();
  const model::Joint& a = root.joints[pair.a];
  const model::Joint& b = root.joints[pair.b];
  if (a.axes.size() != 1 || b.axes.size() != 1 || a.type != b.type) return std::nullopt;
  if (!a.axes.front().xyz.written || !b.axes.front().xyz.written) return std::nullopt;
  if (a.type == model::JointType::kFixed) return std::nullopt;
  const auto axis_a = frames.axis({pair.a}, 0), axis_b = frames.axis({pair.b}, 0);
  const auto X_WA = frames.pose(model::Id<model::Joint>{pair.a});
  const auto X_WB = frames.pose(model::Id<model::Joint>{pair.b});
  if (!axis_a || !axis_b || !X_WA || !X_WB) return std::nullopt;
  const Vector3 between = X_WA->translation - X_WB->translation;
  constexpr double kApart = 1e-3;  // m
  if (length(between) < kApart) return std::nullopt;
  return AxisPair{pair, likeness_of(*axis_a, *axis_b, between),
                  robot::turns_on_and_on(a) && robot::turns_on_and_on(b)};
}

/// How well a twin in front or behind confirms the axis: its cosine; zero without one.
double confirmed(std::uint32_t joint, const std::vector<robot::Twins>& along, Context& context) {
  const auto axis = context.frames().axis({joint}, 0);
  for (const robot::Twins& pair : along) {
    if (pair.a != joint && pair.b != joint) continue;
    const auto other = context.frames().axis({pair.a == joint ? pair.b : pair.a}, 0);
    if (axis && other) return std::abs(dot(*axis, *other));
  }
  return 0;
}

/// Whether a wheel's shape is round about the axis of its joint.
bool rolls(std::uint32_t joint, const std::vector<robot::Wheel>& wheels) {
  return std::any_of(wheels.begin(), wheels.end(),
                     [joint](const robot::Wheel& wheel) { return wheel.joint == joint; });
}

bool first_is_wrong(const robot::Twins& pair, Context& context) {
  const auto wheels = robot::wheels(context.root(), context.frames(), context.assembled());
  const bool a_rolls = rolls(pair.a, wheels), b_rolls = rolls(pair.b, wheels);
  if (a_rolls != b_rolls) return b_rolls;
  const auto along = twins_of(context.root().joints, robot::Side::kAlong, context.root());
  return confirmed(pair.a, along, context) < confirmed(pair.b, along, context);
}

void check(const model::Root& root, Context& context) {
  if (root.joints.size() < 2) return;
  std::vector<AxisPair> pairs;
  for (const robot::Twins& pair : context.assembled().joint_twins) {
    if (const auto one = compared(pair, context)) pairs.push_back(*one);
  }
  const auto good = static_cast<std::size_t>(std::count_if(
      pairs.begin(), pairs.end(), [](const AxisPair& one) { return one.likeness > kAlong; }));
  for (const AxisPair& one : pairs) {
    if (one.likeness > kAcross ||
        written_alike(root.joints[one.joints.a], root.joints[one.joints.b]))
      continue;
    // An arm that is turned on its side has no joint like its twin's.
    constexpr std::size_t kShare = 3;
    if (!one.wheels && good < kShare * (pairs.size() - good)) continue;
    const bool first = first_is_wrong(one.joints, context);
    const model::Joint& wrong = root.joints[first ? one.joints.a : one.joints.b];
    const model::Joint& right = root.joints[first ? one.joints.b : one.joints.a];
    context.report({.where = wrong.axes.front().xyz.span,
                    .message = fmt::format("the axis is {:.0f}° off that of joint '{}', which it "
                                           "should be parallel to or the mirror image of",
                                           std::acos(one.likeness) * 180 / 3.14159265358979323846,
                                           right.name.value),
                    .subject = context.subject(wrong),
                    .related = {{right.axes.front().xyz.span, "its twin's axis"}}});
  }
}

Rule rule() {
  return {
      .name = "twin-axis-differs",
      .severity = Severity::kWarning,
      .summary = "the joint axes of a left and a right part do not match",
      .why = "One wheel tumbles while the other rolls; one leg swings sideways while the other "
             "steps. The axes of two joints whose names say left and right are neither parallel "
             "nor mirror images, with all joints at zero. The finding is at the one that does not "
             "fit its wheel's shape, or its twin in front or behind.",
      .what_to_do = "Write the axis in the joint's own frame, as that of the other side; `rigor "
                    "inspect` prints both in one frame.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::twin_axis_differs
