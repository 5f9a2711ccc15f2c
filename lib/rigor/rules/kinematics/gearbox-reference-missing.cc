// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <variant>

#include <rigor/model/names.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>

namespace rigor::rules::gearbox_reference_missing {

void check(const model::Joint& joint, Context& context) {
  if (joint.type != model::JointType::kGearbox || !joint.model) return;
  if (has_xacro_child(joint.site, context)) return;
  const std::string_view name = joint.gearbox_reference.value;
  if (name.empty()) {
    context.report(
        {.where = joint.type_name.span,
         .message =
             "the gearbox joint has no <gearbox_reference_body>: the angles of its gears have "
             "nothing to be measured from",
         .subject = context.subject(joint)});
    return;
  }
  const model::Names& names = context.frames().names();
  if (names.find_link(joint.model, name)) return;
  if (!std::holds_alternative<std::monostate>(names.find({joint.model, {}}, name))) return;
  context.report(
      {.where = joint.gearbox_reference.span,
       .message = "the gears turn in '" + std::string(name) + "', which this model does not have",
       .subject = context.subject(joint)});
}

Rule rule() {
  return {
      .name = "gearbox-reference-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a gearbox joint has no reference body",
      .why = "The ratio is between the angles of parent and child to a third body. Gazebo classic "
             "says \"Gearbox joint missing reference body\" and has nothing to measure the angles "
             "from.",
      .what_to_do =
          "Write <gearbox_reference_body> with the name of the link that both gears turn in.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::gearbox_reference_missing
