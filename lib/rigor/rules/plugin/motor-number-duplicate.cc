// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::motor_number_duplicate {

void check(const model::Root& root, Context& context) {
  struct Motor {
    Span where;
    std::string joint;
  };
  // A topic of its own is another array.
  using Place = std::tuple<std::uint32_t, std::string, std::string, std::string>;
  std::map<Place, Motor> seen;
  for (const model::Plugin& plugin : root.plugins) {
    if (!root.own(plugin.site)) continue;
    const GazeboSystem* const system = gazebo_system(plugin.filename.value);
    if (system == nullptr || system->library != "multicopter-motor-model") continue;
    const auto* number = find(plugin.parameters, "actuator_number");
    if (number == nullptr) number = find(plugin.parameters, "motorNumber");
    if (number == nullptr) continue;
    const auto text = [&plugin](const char* name) {
      const auto* parameter = find(plugin.parameters, name);
      return parameter != nullptr ? parameter->value.value : std::string();
    };
    const std::string joint = text("jointName");
    const Place place{plugin.model.value, text("robotNamespace"), text("commandSubTopic"),
                      number->value.value};
    const auto [entry, first] = seen.try_emplace(place, Motor{number->value.span, joint});
    if (first || entry->second.joint == joint) continue;
    context.report({.where = number->value.span,
                    .message = "two motors have the number " + std::get<3>(place),
                    .subject = context.subject(plugin),
                    .related = {{entry->second.where, "the other one"}}});
  }
}

Rule rule() {
  return {
      .name = "motor-number-duplicate",
      .severity = Severity::kWarning,
      .summary = "two motors of a multicopter have the same number",
      .why = "The number of a MulticopterMotorModel is an index into the speeds that are "
             "commanded. Two motors with one number turn alike, and the speed meant for one of "
             "them goes nowhere: the vehicle tips over when it takes off.",
      .what_to_do = "Number the motors from 0, each with its own number.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::motor_number_duplicate
