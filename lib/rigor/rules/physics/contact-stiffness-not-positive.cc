// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::contact_stiffness_not_positive {

void check(const model::Collision& collision, Context& context) {
  if (const auto& kp = collision.surface.kp; kp.written && kp.value <= 0) {
    context.report(
        {.where = kp.span,
         .message = fmt::format("the contact's stiffness kp is {} N/m: nothing pushes the "
                                "bodies apart",
                                kp.value),
         .subject = context.subject(collision)});
  }
  if (const auto& kd = collision.surface.kd; kd.written && kd.value < 0) {
    context.report(
        {.where = kd.span,
         .message = fmt::format("the contact's damping kd is {} N·s/m: it adds energy to "
                                "each touch",
                                kd.value),
         .subject = context.subject(collision)});
  }
}

Rule rule() {
  return {
      .name = "contact-stiffness-not-positive",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a contact has no stiffness, or a negative damping",
      .why = "Gazebo classic makes ODE's error correction of both, h kp / (h kp + kd): with kp 0 "
             "nothing is corrected and the body sinks, and negative ones leave the range that ODE "
             "can solve. No checker looks at them.",
      .what_to_do = "Leave them out (1e12 and 1), or write the stiffness of the material in N/m.",
      .checks = {on<model::Collision>(check)},
  };
}

}  // namespace rigor::rules::contact_stiffness_not_positive
