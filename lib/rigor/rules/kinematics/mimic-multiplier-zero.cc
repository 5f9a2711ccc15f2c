// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::mimic_multiplier_zero {

void check(const model::Joint& joint, Context& context) {
  for (const model::Axis& axis : joint.axes) {
    if (!axis.mimic || !axis.mimic->multiplier.written) continue;
    if (axis.mimic->multiplier.value != 0) continue;
    context.report({.where = axis.mimic->multiplier.span,
                    .message = "the multiplier is 0: the joint does not move with '" +
                               axis.mimic->joint.value + "'",
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "mimic-multiplier-zero",
      .severity = Severity::kWarning,
      .summary = "a joint mimics another with the multiplier zero",
      .why = "Its position is the offset, wherever the other joint goes: it never moves, and no "
             "controller may move it.",
      .what_to_do = "Write the ratio of the two joints; 1 when they move alike, -1 when they move "
                    "against each other.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::mimic_multiplier_zero
