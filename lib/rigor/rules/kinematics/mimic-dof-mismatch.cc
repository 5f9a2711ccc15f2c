// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <optional>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mimic_dof_mismatch {

/// What is wrong between the two; empty when they can go together.
std::string mismatch(const model::Joint& joint, const model::Joint& leader, std::size_t axis,
                     const Context& context) {
  if (leader.type == model::JointType::kUnknown || joint.type == model::JointType::kUnknown) {
    return {};
  }
  const std::size_t leads = degrees_of_freedom(leader.type);
  const std::size_t follows = degrees_of_freedom(joint.type);
  if (context.is_sdf() && axis >= leader.axes.size()) return {};  // mimic-axis-invalid
  if (leads == 0) return "which is fixed: this one stays where it is";
  if (follows == 0) return "but is fixed itself";
  if (context.is_sdf()) return axis < leads ? "" : "which has no second axis";
  if (leads == follows) return {};
  return fmt::format("which is {}, while it is {} itself", to_string(leader.type),
                     to_string(joint.type));
}

/// A fixed joint stays where it is with or without a mimic.
std::optional<Severity> severity_of(const model::Joint& joint) {
  if (joint.type == model::JointType::kFixed) return Severity::kInfo;
  return std::nullopt;
}

void check(const model::Joint& joint, Context& context) {
  for (const model::Axis& axis : joint.axes) {
    if (!axis.mimic) continue;
    const auto leader = leader_of(context.frames(), joint, *axis.mimic);
    if (!leader) continue;
    const std::string why =
        mismatch(joint, context.root()[leader], leading_axis(*axis.mimic), context);
    if (why.empty()) continue;
    context.report({.where = axis.mimic->joint.span,
                    .message = "mimics the joint '" + axis.mimic->joint.value + "', " + why,
                    .subject = context.subject(joint),
                    .severity = severity_of(joint)});
  }
}

Rule rule() {
  return {
      .name = "mimic-dof-mismatch",
      .severity = Severity::kWarning,
      .summary = "a mimic joint and its leader differ in degrees of freedom",
      .why = "MoveIt ignores such a mimic; elsewhere the joint does not move. A joint follows "
             "another by one number: the position of both. A fixed joint has none, and a planar, "
             "floating or ball joint has several. On a joint that is fixed itself the mimic has no "
             "effect: that is an info.",
      .what_to_do = "Name a joint with one axis, or remove the mimic.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::mimic_dof_mismatch
