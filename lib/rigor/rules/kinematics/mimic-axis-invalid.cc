// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mimic_axis_invalid {

void check(const model::Joint& joint, Context& context) {
  for (const model::Axis& axis : joint.axes) {
    if (!axis.mimic) continue;
    const model::Field<std::string>& name = axis.mimic->axis;
    const Span where = name.written ? name.span : axis.mimic->joint.span;
    if (name.value != "axis" && name.value != "axis2") {
      context.report({.where = where,
                      .message = "'" + name.value + "' is no axis that a mimic can follow",
                      .subject = context.subject(joint),
                      .help = "it is one of axis, axis2"});
      continue;
    }
    const auto leader = leader_of(context.frames(), joint, *axis.mimic);
    if (!leader || leading_axis(*axis.mimic) < context.root()[leader].axes.size()) continue;
    context.report({.where = where,
                    .message = "mimics <" + name.value + "> of the joint '" +
                               axis.mimic->joint.value + "', which has none",
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "mimic-axis-invalid",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .summary = "a mimic follows an axis that its leader does not have",
      .why = "libsdformat 14 and later refuse the file; libsdformat 12 passes over every <mimic>.",
      .what_to_do =
          "Name an axis that is written in the leading joint: axis, or axis2 of one with two.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::mimic_axis_invalid
