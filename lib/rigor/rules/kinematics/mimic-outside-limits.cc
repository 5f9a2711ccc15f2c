// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mimic_outside_limits {

// Limits are often written with three digits.
constexpr double kTolerance = 0.01;

bool bounded(const model::Joint& joint, const model::Axis& axis) {
  return is_limited(joint.type) && std::isfinite(axis.lower.value) &&
         std::isfinite(axis.upper.value) && axis.lower.value < axis.upper.value;
}

void check(const model::Joint& joint, Context& context) {
  for (const model::Axis& axis : joint.axes) {
    if (!axis.mimic || !bounded(joint, axis)) continue;
    const model::Mimic& mimic = *axis.mimic;
    const auto id = leader_of(context.frames(), joint, mimic);
    if (!id) continue;
    const model::Joint& leader = context.root()[id];
    const std::size_t index = leading_axis(mimic);
    if (index >= leader.axes.size() || !bounded(leader, leader.axes[index])) continue;
    const auto led = [&mimic](double position) {
      return mimic.multiplier.value * (position - mimic.reference.value) + mimic.offset.value;
    };
    const auto [least, most] =
        std::minmax({led(leader.axes[index].lower.value), led(leader.axes[index].upper.value)});
    const double slack = kTolerance * (axis.upper.value - axis.lower.value);
    if (least >= axis.lower.value - slack && most <= axis.upper.value + slack) continue;
    const char* unit = position_unit(joint.type);
    context.report({.where = mimic.site.name,
                    .message = fmt::format(
                        "following '{0}', the joint would go from {1:.4g} to {2:.4g} "
                        "{5}, but its own limits are {3:.4g} and {4:.4g} {5}",
                        mimic.joint.value, least, most, axis.lower.value, axis.upper.value, unit),
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "mimic-outside-limits",
      .severity = Severity::kWarning,
      .summary = "a joint that mimics another is led out of its limits",
      .why = "Where the leader may go and the follower may not, the two contradict each other: "
             "whoever moves the leader to its stop takes the follower past its own, or the "
             "follower holds them both.",
      .what_to_do = "Make the limits of the follower multiplier · leader + offset, or narrow those "
                    "of the leader.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::mimic_outside_limits
