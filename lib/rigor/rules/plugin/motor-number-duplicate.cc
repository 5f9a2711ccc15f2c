// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include <rigor/read/values.h>
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
    const xml::Element element = context.element(plugin.site);
    auto number = element.child("actuator_number");
    if (!number) number = element.child("motorNumber");
    if (!number) continue;
    const auto text = [&element](const char* name) {
      const auto child = element.child(name);
      return child ? std::string(read::trimmed(child->text())) : std::string();
    };
    const std::string joint = text("jointName");
    const Place place{plugin.model.value, text("robotNamespace"), text("commandSubTopic"),
                      std::string(read::trimmed(number->text()))};
    const auto [entry, first] = seen.try_emplace(place, Motor{number->text_span(), joint});
    if (first || entry->second.joint == joint) continue;
    context.report({.where = number->text_span(),
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
