// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::safety_limits_outside {

constexpr double kTolerance = 1e-6;

/// Robots of PR2's tradition write ±10 where they have no soft limits: whole numbers that are larger than
/// any range of a revolute joint.
bool means_none(double lower, double upper) {
  constexpr double kMin = 10;
  return lower == -upper && upper >= kMin && std::floor(upper) == upper;
}

void check(const model::Joint& joint, Context& context) {
  if (!joint.safety || joint.axes.empty() || !is_limited(joint.type)) return;
  const model::Field<double>& lower = joint.safety->soft_lower;
  const model::Field<double>& upper = joint.safety->soft_upper;
  const model::Axis& axis = joint.axes.front();
  if (!lower.written || !upper.written || !axis.limit_written) return;
  if (axis.lower.value > axis.upper.value) return;  // joint-limit-inverted says so
  const bool swapped = lower.value > upper.value;
  const bool below = lower.value < axis.lower.value - kTolerance;
  const bool above = upper.value > axis.upper.value + kTolerance;
  if (!swapped && !below && !above) return;
  const bool none = below && above && means_none(lower.value, upper.value);
  const auto severity = none ? std::optional(Severity::kInfo) : std::nullopt;
  std::string message;
  if (swapped) {
    message = fmt::format("the lower soft limit {:.6g} is above the upper one {:.6g}", lower.value,
                          upper.value);
  } else if (below && above) {
    message =
        fmt::format("the soft limits {:.6g} and {:.6g} reach beyond the limits {:.6g} and {:.6g}",
                    lower.value, upper.value, axis.lower.value, axis.upper.value);
  } else {
    message = fmt::format("the {} soft limit {:.6g} reaches beyond the limit {:.6g}",
                          below ? "lower" : "upper", below ? lower.value : upper.value,
                          below ? axis.lower.value : axis.upper.value);
  }
  context.report({.where = joint.safety->site.name,
                  .message = std::move(message),
                  .subject = context.subject(joint),
                  .severity = severity});
}

Rule rule() {
  return {
      .name = "safety-limits-outside",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "safety_controller soft limits exceed the joint limits",
      .why = "Beyond the hard limits a soft limit has no effect: it is to slow the joint before it "
             "reaches them. When soft limits are inverted, no position is within them. Limits such "
             "as ±10 on both sides mean \"none\" in many robots: they are an info.",
      .what_to_do = "Set soft_lower_limit and soft_upper_limit between lower and upper.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::safety_limits_outside
