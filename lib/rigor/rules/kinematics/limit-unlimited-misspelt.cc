// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::limit_unlimited_misspelt {

// The number that SDF has for "no limit" before 1.10.
constexpr double kNone = 1e16;

/// Whether a limit beside ±1e16 is another spelling of that number: ±1e-16, -1e16 above, 1e6 or 1e15.
bool is_slip(double limit, double sign) {
  if (limit == 0 || !std::isfinite(limit) || limit == sign * kNone) return false;
  const double exponent = std::log10(std::abs(limit));
  const bool power = std::abs(exponent - std::round(exponent)) < 1e-9;
  const bool far = std::abs(exponent) > 4.5;  // of radians and meters, which are real limits
  return power && far;
}

void check(const model::Joint& joint, Context& context) {
  if (!is_limited(joint.type)) return;
  for (const model::Axis& axis : joint.axes) {
    if (!axis.lower.written || !axis.upper.written) continue;
    const bool lower_none = axis.lower.value == -kNone;
    const bool upper_none = axis.upper.value == kNone;
    if (lower_none == upper_none) continue;
    const auto& limit = lower_none ? axis.upper : axis.lower;
    const double sign = lower_none ? 1 : -1;
    if (!is_slip(limit.value, sign)) continue;
    context.report({.where = limit.span,
                    .message = fmt::format("the {} limit is {:g}, beside {:g}: {:g} may be meant",
                                           lower_none ? "upper" : "lower", limit.value,
                                           -sign * kNone, sign * kNone),
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "limit-unlimited-misspelt",
      .severity = Severity::kWarning,
      .summary = "one of two unlimited joint limits has a wrong sign or exponent",
      .why = "1e-16 is zero, and a joint between -1e16 and 1e-16 rotates one way only; with "
             "another exponent consumers take the number for a limit. ±1e16 means \"no limit\" to "
             "libsdformat.",
      .what_to_do = "Write -1e16 and 1e16, from SDF 1.10 on -inf and inf; in a URDF make the joint "
                    "continuous.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_unlimited_misspelt
