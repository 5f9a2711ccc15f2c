// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstdint>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::limit_looks_like_millimeters {

constexpr double kMin = 20;     // rails of that length exist, between links as far apart
constexpr double kMax = 5000;   // larger ones represent "no limit"
constexpr double kApart = 0.1;  // of the limit: links that are nearer are small

/// Millimeters are written as round numbers.
bool looks_like_millimeters(double limit) {
  const double size = std::abs(limit);
  return size >= kMin && size <= kMax && std::fmod(size, 5) == 0;
}

bool has_shape(const model::Link& link) {
  return !link.visuals.empty() || !link.collisions.empty();
}

/// Whether both links are things, and near to each other: a base that slides on the ground is
/// made of links without a shape.
bool is_small(const model::Root& root, const model::Frames& frames, model::Id<model::Joint> id,
              double limit) {
  const auto& ends = frames.ends(id);
  if (!ends.parent || !ends.child) return false;
  if (!has_shape(root[ends.parent]) || !has_shape(root[ends.child])) return false;
  const auto parent = frames.pose(ends.parent);
  const auto child = frames.pose(ends.child);
  return parent && child &&
         length(child->translation - parent->translation) < kApart * std::abs(limit);
}

Fix in_meters(const model::Axis& axis) {
  Fix fix{"write meters", Applicability::kUnsafe, {}};
  for (const model::Field<double>* limit : {&axis.lower, &axis.upper}) {
    if (!limit->written || !std::isfinite(limit->value) || limit->value == 0) continue;
    fix.edits.push_back({limit->span, write::joined({limit->value / 1000})});
  }
  return fix;
}

void check(const model::Root& root, Context& context) {
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const model::Joint& joint = root.joints[i];
    if (joint.type != model::JointType::kPrismatic || joint.axes.empty()) continue;
    const model::Axis& axis = joint.axes.front();
    const bool upper = axis.upper.written && looks_like_millimeters(axis.upper.value);
    if (!upper && !(axis.lower.written && looks_like_millimeters(axis.lower.value))) continue;
    const model::Field<double>& limit = upper ? axis.upper : axis.lower;
    if (!root.own(joint.site) || !is_small(root, context.frames(), {i}, limit.value)) continue;
    context.report(
        {.where = limit.span,
         .message = fmt::format(
             "the limit {0} looks like millimeters: limits are in meters, and {0} mm is {1} m",
             limit.value, limit.value / 1000),
         .subject = context.subject(joint),
         .fix = in_meters(axis)});
  }
}

Rule rule() {
  return {
      .name = "limit-looks-like-millimeters",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a limit of a sliding joint looks like millimeters",
      .why = "A finger that may go 40 m has no stop: it leaves its gripper as soon as something "
             "pushes it. Limits of prismatic joints are in meters.",
      .what_to_do = "Convert the limits to meters: 40 mm are 0.04.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::limit_looks_like_millimeters
