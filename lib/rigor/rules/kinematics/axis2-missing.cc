// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>

namespace rigor::rules::axis2_missing {

void check(const model::Joint& joint, Context& context) {
  if (degrees_of_freedom(joint.type) != 2 || joint.axes.size() != 1) return;
  const bool second = context.bytes(joint.axes.front().site.name) == "axis2";
  if (second || has_xacro_child(joint.site, context)) return;
  context.report({.where = joint.type_name.span,
                  .message = "a " + std::string(to_string(joint.type)) +
                             " joint has two axes, and this one has no <axis2>",
                  .subject = context.subject(joint)});
}

Rule rule() {
  return {
      .name = "axis2-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a joint with two axes has only one",
      .why = "The second axis is z of the joint's frame then, as SDF defaults an axis, or is not "
             "there at all: the joint turns another way than was meant, or about one axis only.",
      .what_to_do = "Write <axis2>, or make the joint revolute.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::axis2_missing
