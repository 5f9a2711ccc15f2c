// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::limit_used_as_unlimited {

constexpr double kHuge = 1e6;  // turns of a screw, or meters of a rail, that are not built
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
    context.report(
        {.where = limit.span,
         .message = fmt::format("the limit {:.3g} {} is used as \"unlimited\": {} means that",
                                limit.value, position_unit(joint.type),
                                context.is_sdf() ? "'inf'" : "a continuous joint"),
         .subject = context.subject(joint),
         .fix = without_limits(axis, context)});
  }
}

Rule rule() {
  return {
      .name = "limit-used-as-unlimited",
      .severity = Severity::kInfo,
      .fix = FixGrade::kUnsafe,
      .summary = "a finite number is used as \"unlimited\"",
      .why = "Before SDF 1.10 ±1e16 meant \"no limit\" in the format, and other huge numbers are "
             "used alike. Since 1.10 it is infinity, and URDF has continuous joints. Tools that do "
             "not know the convention use the number as a limit: the range of a slider or of "
             "random positions is meaningless.",
      .what_to_do = "In SDF 1.10 and later write inf, or omit the limit. In a URDF make a revolute "
                    "joint continuous.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_used_as_unlimited
