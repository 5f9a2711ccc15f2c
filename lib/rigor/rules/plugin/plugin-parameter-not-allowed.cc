// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <iterator>
#include <string>
#include <string_view>

#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>

namespace rigor::rules::plugin_parameter_not_allowed {

struct Choice {
  std::string_view library;
  std::string_view parameter;
  std::string_view values;
};

constexpr Choice kChoices[] = {
    {"multicopter-motor-model", "turningDirection", "cw ccw"},
    {"multicopter-motor-model", "motorType", "velocity position force"},
    {"odometry-publisher", "dimensions", "2 3"},
};

void check(const model::Plugin& plugin, Context& context) {
  const GazeboSystem* const system = gazebo_system(plugin.filename.value);
  if (system == nullptr) return;
  for (const Choice& choice : kChoices) {
    if (choice.library != system->library) continue;
    const auto* given = find(plugin.parameters, choice.parameter);
    if (given == nullptr) continue;
    const std::string_view value = given->value.value;
    if (has_word(choice.values, value) || has_xacro(value)) continue;
    std::string list;
    some_word(choice.values, [&list](std::string_view word) {
      list += (list.empty() ? "" : ", ") + std::string(word);
      return false;
    });
    context.report({.where = value.empty() ? given->site.name : given->value.span,
                    .message = "'" + std::string(value) + "' is no value of <" +
                               std::string(choice.parameter) + ">",
                    .subject = context.subject(plugin),
                    .help = "it takes " + list});
  }
}

Rule rule() {
  return {
      .name = "plugin-parameter-not-allowed",
      .severity = Severity::kWarning,
      .summary = "a parameter of a plugin has a value that the plugin does not know",
      .why = "A few parameters are choices: turningDirection of MulticopterMotorModel is cw or "
             "ccw, dimensions of OdometryPublisher is 2 or 3. Other values are an error in the "
             "log, and the default is used: a rotor that was to turn the other way does not.",
      .what_to_do = "Write one of the values.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_parameter_not_allowed
