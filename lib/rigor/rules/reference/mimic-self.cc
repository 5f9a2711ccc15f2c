// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::mimic_self {

void check(const model::Joint& joint, Context& context) {
  for (const model::Axis& axis : joint.axes) {
    if (!axis.mimic || axis.mimic->joint.value != joint.name.value) continue;
    // A two-axis joint may follow its own other axis.
    if (context.is_sdf() && joint.axes.size() > 1) continue;
    if (joint.name.value.empty()) continue;
    context.report({.where = axis.mimic->joint.span,
                    .message = "the joint '" + joint.name.value + "' mimics itself",
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "mimic-self",
      .severity = Severity::kError,
      .summary = "a joint mimics itself",
      .why = "A position that is computed from itself has no value: newer libsdformat and Drake "
             "refuse it, others leave the joint unmoved or follow the reference for ever.",
      .what_to_do = "Name the joint that leads, or take the mimic out.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::mimic_self
