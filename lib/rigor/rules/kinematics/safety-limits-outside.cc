// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::safety_limits_outside {

constexpr double kTolerance = 1e-6;

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
                  .subject = context.subject(joint)});
}

Rule rule() {
  return {
      .name = "safety-limits-outside",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "the soft limits of a joint are not within its hard ones",
      .why = "Soft limits are there to slow the joint before it reaches its stop. Beyond the stop "
             "they come too late, and swapped no position is within them.",
      .what_to_do = "Let soft_lower_limit and soft_upper_limit lie between lower and upper.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::safety_limits_outside
