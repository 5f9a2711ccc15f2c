// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <unordered_map>

#include <rigor/rules/rule.h>

namespace rigor::rules::transmission_actuator_duplicate {

void check(const model::Root& root, Context& context) {
  std::unordered_map<std::string, Span> first;
  for (const model::Parameter& transmission : root.transmissions) {
    if (!root.own(transmission.site)) continue;
    for (const model::Parameter& part : transmission.children) {
      const auto* name = part.name == "actuator" ? attribute(part, "name") : nullptr;
      if (name == nullptr || name->value.empty()) continue;
      const auto [known, is_new] = first.emplace(name->value, name->span);
      if (is_new) continue;
      context.report({.where = name->span,
                      .message = "the actuator '" + name->value + "' is in a second transmission",
                      .related = {{known->second, "the first"}}});
    }
  }
}

Rule rule() {
  return {
      .name = "transmission-actuator-duplicate",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "two transmissions have the same actuator",
      .why = "ros_control registers the handle of an actuator once per name, so that the second "
             "transmission overwrites the first. An actuator has one position and one command; "
             "most often the block was copied and its actuator not renamed.",
      .what_to_do = "Give each transmission an actuator of its own, for example elbow_motor.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::transmission_actuator_duplicate
