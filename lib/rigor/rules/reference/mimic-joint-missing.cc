// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <variant>
#include <vector>

#include <rigor/model/names.h>
#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mimic_joint_missing {

bool exists(const model::Names& names, model::Id<model::Model> scope, const std::string& joint) {
  const model::Named named = names.find({scope, {}}, joint);  // also of a nested model
  return names.find_joint(scope, joint) || std::holds_alternative<model::Id<model::Joint>>(named);
}

void check(const model::Root& root, Context& context) {
  const model::Names& names = context.frames().names();
  for (const model::Joint& joint : root.joints) {
    if (!joint.model || !root.own(joint.site)) continue;
    for (const model::Axis& axis : joint.axes) {
      if (!axis.mimic || axis.mimic->joint.value.empty()) continue;
      const std::string& leader = axis.mimic->joint.value;
      if (exists(names, joint.model, leader)) continue;
      const auto others = [&] {
        std::vector<std::string> all;
        for (const auto id : root[joint.model].joints) all.push_back(root[id].name.value);
        return all;
      };
      context.report(with_nearest(
          {.where = axis.mimic->joint.span,
           .message = "mimics the joint '" + leader + "', which this model does not have",
           .subject = context.subject(joint)},
          leader, others, context));
    }
  }
}

Rule rule() {
  return {
      .name = "mimic-joint-missing",
      .severity = Severity::kError,
      .fix = FixGrade::kUnsafe,
      .summary = "a joint mimics one that does not exist",
      .why = "urdfdom takes the model as it is, and what follows differs: MoveIt and "
             "robot_state_publisher leave the joint where it is, Drake and newer libsdformat "
             "refuse the model.",
      .what_to_do = "Name a joint of the same model.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mimic_joint_missing
