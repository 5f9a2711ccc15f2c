// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::transmission_value_malformed {

bool is_number(std::string_view name) {
  return name == "mechanicalReduction" || name == "offset" || name == "motorTorqueConstant" ||
         name == "mechanical_reduction";
}

void check_part(const model::Parameter& part, Context& context) {
  if (is_number(part.name) && !write::number_in(part.value.value) && !has_xacro(part.value.value)) {
    const std::string text = "'" + part.value.value + "'";
    context.report({.where = part.value.value.empty() ? part.site.name : part.value.span,
                    .message = "<" + part.name + "> takes a number, not " +
                               (part.value.value.empty() ? "nothing" : text)});
  }
  for (const model::Parameter& inner : part.children) check_part(inner, context);
}

void check(const model::Root& root, Context& context) {
  for (const model::Parameter& transmission : root.transmissions) {
    if (root.own(transmission.site)) check_part(transmission, context);
  }
}

Rule rule() {
  return {
      .name = "transmission-value-malformed",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a value of a transmission is not a number",
      .why = "ros_control and ros2_control load a transmission only when its numbers can be read: "
             "else they log an error, and the joint has no hardware interface. The readers of the "
             "robot itself (urdfdom, libsdformat) ignore <transmission>.",
      .what_to_do =
          "Write the number alone, for example <mechanicalReduction>50</mechanicalReduction>.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::transmission_value_malformed
