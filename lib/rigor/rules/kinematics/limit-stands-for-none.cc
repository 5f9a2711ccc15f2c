// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::limit_stands_for_none {

constexpr double kHuge = 1e6;  // turns of a screw, or metres of a rail, that nobody builds
constexpr int kInfiniteSince = 10;

bool stands_for_none(const model::Field<double>& limit) {
  return limit.written && std::isfinite(limit.value) && std::abs(limit.value) >= kHuge;
}

/// SDF says so with infinity. In URDF another type of joint does.
std::optional<Fix> without_limits(const model::Axis& axis, const Context& context) {
  if (!context.is_sdf()) return std::nullopt;
  Fix fix{"write infinity", Applicability::kUnsafe, {}};
  for (const model::Field<double>* limit : {&axis.lower, &axis.upper}) {
    if (!stands_for_none(*limit)) continue;
    fix.edits.push_back({limit->span, limit->value < 0 ? "-inf" : "inf"});
  }
  return fix;
}

void check(const model::Joint& joint, Context& context) {
  if (context.is_sdf() && context.root().version < kInfiniteSince) return;
  if (!is_limited(joint.type)) return;
  for (const model::Axis& axis : joint.axes) {
    const bool lower = stands_for_none(axis.lower);
    if (!lower && !stands_for_none(axis.upper)) continue;
    const model::Field<double>& limit = lower ? axis.lower : axis.upper;
    context.report({.where = limit.span,
                    .message = fmt::format("the limit {:.3g} {} is meant as no limit: {} says so",
                                           limit.value, position_unit(joint.type),
                                           context.is_sdf() ? "'inf'" : "a continuous joint"),
                    .subject = context.subject(joint),
                    .fix = without_limits(axis, context)});
  }
}

Rule rule() {
  return {
      .name = "limit-stands-for-none",
      .severity = Severity::kInfo,
      .fix = FixGrade::kUnsafe,
      .summary = "a huge limit stands for none",
      .why = "Before SDF 1.10 ±1e16 was how the format said \"no limit\", and other huge numbers "
             "are meant so. Since 1.10 infinity says it, and URDF has continuous joints. Who does "
             "not know the custom takes the number for a limit: a slider or a random position is "
             "somewhere in a range without end.",
      .what_to_do = "In SDF 1.10 and later write inf, or leave the limit out. In a URDF make a "
                    "revolute joint continuous.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_stands_for_none
