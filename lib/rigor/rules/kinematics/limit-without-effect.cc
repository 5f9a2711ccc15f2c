// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <utility>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::limit_without_effect {

// A whole turn, or nothing but zeros, means no limit.
constexpr double kWholeTurn = 6.28;

void check(const model::Joint& joint, Context& context) {
  const bool turns_freely = joint.type == model::JointType::kContinuous;
  if (!turns_freely && joint.type != model::JointType::kFloating &&
      joint.type != model::JointType::kPlanar) {
    return;
  }
  for (const model::Axis& axis : joint.axes) {
    if (!axis.lower.written && !axis.upper.written) continue;
    if (!(axis.lower.value < axis.upper.value)) continue;
    if (turns_freely && axis.upper.value - axis.lower.value >= kWholeTurn) continue;
    Finding finding{
        .where = axis.lower.written ? axis.lower.span : axis.upper.span,
        .message = fmt::format("a {} joint has no limits: these, {:.6g} and {:.6g}, are ignored",
                               to_string(joint.type), axis.lower.value, axis.upper.value),
        .subject = context.subject(joint)};
    if (turns_freely) {
      finding.fix =
          Fix{"make it revolute", Applicability::kUnsafe, {{joint.type_name.span, "revolute"}}};
    }
    context.report(std::move(finding));
  }
}

Rule rule() {
  return {
      .name = "limit-without-effect",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a joint that has no limits is given some",
      .why = "A continuous joint is unlimited by its type, and no consumer reads lower and upper: "
             "the joint moves past them.",
      .what_to_do =
          "Make the joint revolute (or prismatic) if the limits are meant; else remove them.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_without_effect
