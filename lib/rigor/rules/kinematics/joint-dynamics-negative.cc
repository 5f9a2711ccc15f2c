// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <limits>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::joint_dynamics_negative {

constexpr double kNegativeInfinity = -std::numeric_limits<double>::infinity();

void check(const model::Joint& joint, Context& context) {
  for (const model::Axis& axis : joint.axes) {
    const std::pair<const model::Field<double>*, const char*> coefficients[] = {
        {&axis.damping, "damping"},
        {&axis.friction, "friction"},
        {&axis.spring_stiffness, "spring stiffness"}};
    for (const auto& [field, name] : coefficients) {
      if (!field->written || !(field->value < 0) || field->value == kNegativeInfinity) continue;
      Finding finding{
          .where = field->span,
          .message = fmt::format("the {} is {:.6g}: it has to be at least 0", name, field->value),
          .subject = context.subject(joint)};
      finding.fix = Fix{"write it without the sign",
                        Applicability::kUnsafe,
                        {{field->span, write::joined({-field->value})}}};
      context.report(std::move(finding));
    }
  }
}

Rule rule() {
  return {
      .name = "joint-dynamics-negative",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the damping, friction or stiffness of a joint is negative",
      .why = "Such a joint drives itself: each motion makes the next one faster, until the "
             "simulation explodes. Drake refuses it: \"Joint damping must be a non-negative "
             "number\". libsdformat says nothing.",
      .what_to_do = "Write a number of at least 0.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::joint_dynamics_negative
