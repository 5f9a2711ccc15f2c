// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::limit_equal {

/// Of a joint that stays at zero: a fixed one stands where it stood.
std::optional<Fix> fixed_instead(const model::Joint& joint, const model::Axis& axis,
                                 const Context& context) {
  std::vector<Edit> edits{{joint.type_name.span, "fixed"}};
  if (axis.site.element != joint.site.element) {
    const auto without_axis = removed(context, axis.site);
    edits.insert(edits.end(), without_axis.begin(), without_axis.end());
  }
  return fix_of("make it fixed", Applicability::kUnsafe, std::move(edits));
}

/// URDF: whether effort and velocity say what its motor can, so that it is there to move.
bool has_motor(const Context& context, const model::Joint& joint, const model::Axis& axis) {
  if (!context.is_urdf() || axis.upper.value != 0) return false;
  const double effort = effort_limit(context.root(), joint, axis);
  const double velocity = velocity_limit(context.root(), joint, axis);
  // 1 and 1, or 100 and 100, are what exporters and templates write.
  return std::isfinite(effort) && std::isfinite(velocity) && effort != velocity;
}

/// Whether the robot's other joints of this type, three at least, have room to move.
bool is_only_one(const model::Joint& joint, const Context& context) {
  constexpr std::size_t kFewest = 3;
  std::size_t others = 0;
  for (const model::Joint& other : context.root().joints) {
    if (&other == &joint || other.type != joint.type || other.axes.size() != 1) continue;
    if (other.model != joint.model || !other.axes.front().upper.written) continue;
    if (!(other.axes.front().lower.value < other.axes.front().upper.value)) return false;
    ++others;
  }
  return others >= kFewest;
}

/// A sign that was lost leaves two limits that are the same and not zero.
std::optional<Fix> symmetric_instead(const model::Axis& axis) {
  const std::string text = write::joined({-1 * std::abs(axis.lower.value)});
  const std::string other = write::joined({std::abs(axis.upper.value)});
  std::vector<Edit> edits{{axis.lower.span, text}};
  if (axis.upper.value < 0) edits.push_back({axis.upper.span, other});
  return Fix{"write the lower limit as " + text, Applicability::kUnsafe, std::move(edits)};
}

void check(const model::Joint& joint, Context& context) {
  if (!is_limited(joint.type) || joint.axes.size() != 1) return;
  const model::Axis& axis = joint.axes.front();
  if (!axis.lower.written || !axis.upper.written || axis.mimic) return;
  if (is_stuck(context.root(), joint, axis)) return;
  if (axis.lower.value != axis.upper.value || !std::isfinite(axis.upper.value)) return;
  const bool only_one = is_only_one(joint, context);
  // Files of those versions have no other way to say that a joint is fixed.
  if (context.is_sdf() && context.root().version < 6 && !only_one) return;
  const bool lost_sign = axis.upper.value != 0 && only_one;
  const bool odd = only_one || has_motor(context, joint, axis);
  context.report(
      {.where = axis.upper.span,
       .message = fmt::format("both limits are {} {}: the {} joint cannot move", axis.upper.value,
                              position_unit(joint.type), to_string(joint.type)),
       .subject = context.subject(joint),
       .help = lost_sign
                   ? "all others of the robot have a range: was the sign of the lower one lost?"
                   : "",
       .fix = lost_sign ? symmetric_instead(axis) : fixed_instead(joint, axis, context),
       .severity = odd ? std::optional(Severity::kWarning) : std::nullopt});
}

Rule rule() {
  return {
      .name = "limit-equal",
      .severity = Severity::kInfo,
      .fix = FixGrade::kUnsafe,
      .summary = "the limits of a joint leave it one position",
      .why = "The joint cannot move. Files from before SDF had fixed joints lock a revolute one "
             "so; an engine then solves for a joint and its two stops, which is slower and less "
             "stiff than a fixed joint. It is a warning in a URDF whose joint has an effort and a "
             "velocity, and where three or more joints of the robot have a range and only this has "
             "none.",
      .what_to_do = "Make the joint fixed, or write the limits that were meant.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_equal
