// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>

namespace rigor::rules::limit_missing {

void check(const model::Joint& joint, Context& context) {
  const bool limited =
      joint.type == model::JointType::kRevolute || joint.type == model::JointType::kPrismatic;
  if (!limited || (!joint.axes.empty() && joint.axes.front().limit_written)) return;
  if (has_xacro_child(joint.site, context)) return;
  context.report({.where = joint.site.name,
                  .message = "the " + std::string(to_string(joint.type)) + " joint has no <limit>",
                  .subject = context.subject(joint),
                  .help = joint.type == model::JointType::kRevolute
                              ? "add <limit>, or make the joint continuous"
                              : ""});
}

Rule rule() {
  return {
      .name = "limit-missing",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kAlways},
      .formats = Formats::kUrdf,
      .summary = "a revolute or prismatic joint of a URDF has no limits",
      .why = "urdfdom rejects the whole robot: these two types must have limits.",
      .what_to_do = "Add <limit lower=\"…\" upper=\"…\" effort=\"…\" velocity=\"…\"/>, or make a "
                    "revolute joint continuous.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::limit_missing
