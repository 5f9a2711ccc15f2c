// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::plugin_number_malformed {

/// Parameters that are one number wherever they are used.
constexpr std::string_view kLengths[] = {"wheel_separation", "wheelSeparation", "wheel_radius",
                                         "wheelRadius",      "wheel_diameter",  "wheelDiameter",
                                         "kingpin_width",    "wheel_base",      "wheelbase"};
constexpr std::string_view kNumbers[] = {"updateRate",
                                         "update_rate",
                                         "publish_rate",
                                         "publishRate",
                                         "p_gain",
                                         "i_gain",
                                         "d_gain",
                                         "odom_publish_frequency",
                                         "steering_limit",
                                         "max_velocity",
                                         "min_velocity",
                                         "max_acceleration",
                                         "max_wheel_torque",
                                         "wheelTorque",
                                         "max_wheel_acceleration",
                                         "wheelAcceleration"};

template <class List>
bool has(const List& list, std::string_view name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

void check(const model::Plugin& plugin, Context& context) {
  for (const model::Parameter& given : plugin.parameters) {
    const bool length = has(kLengths, given.name);
    const std::string_view value = given.value.value;
    if ((!length && !has(kNumbers, given.name)) || value.empty() || !given.children.empty())
      continue;
    const auto number = write::number_in(value);
    if (number && !(length && *number < 0)) continue;
    context.report({.where = given.value.span,
                    .message = fmt::format("<{}> is '{}', which is {}", given.name, value,
                                           number ? "no length" : "no number"),
                    .subject = context.subject(plugin)});
  }
}

Rule rule() {
  return {
      .name = "plugin-number-malformed",
      .severity = Severity::kWarning,
      .summary = "a plugin's parameter has to be a number, and is none",
      .why = "Plugins read the digits that the text begins with, and ignore the rest: 0,3 is 0, "
             "and 30cm is 30. Text without any leaves the plugin's own default, mostly without a "
             "message.",
      .what_to_do = "Write the number alone, in SI units and with a decimal point.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_number_malformed
