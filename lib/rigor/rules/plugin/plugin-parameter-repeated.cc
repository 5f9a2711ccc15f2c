// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_parameter_repeated {

/// Joints, links and topics may be several, and so may groups of parameters.
bool may_repeat(const model::Parameter& parameter) {
  const std::string_view name = parameter.name;
  for (const char* part : {"joint", "Joint", "link", "Link", "topic", "Topic"}) {
    if (name.find(part) != name.npos) return true;
  }
  return !parameter.children.empty();
}

/// Controllers of several joints have each parameter once a joint, in the order of the joints.
bool has_lists(const model::Plugin& plugin, const GazeboSystem& system) {
  if (system.library == "joint-trajectory-controller")
    return true;  // of all joints, when it names none
  std::unordered_set<std::string_view> seen;
  for (const model::Parameter& parameter : plugin.parameters) {
    if (may_repeat(parameter) && !seen.insert(parameter.name).second) return true;
  }
  return false;
}

void check(const model::Plugin& plugin, Context& context) {
  const GazeboSystem* const system = gazebo_system(plugin.filename.value);
  if (system == nullptr || system->parameters.empty() || has_lists(plugin, *system)) return;
  std::unordered_map<std::string_view, const model::Parameter*> first;
  for (const model::Parameter& parameter : plugin.parameters) {
    if (may_repeat(parameter) || !has_word(system->parameters, parameter.name)) continue;
    const auto [known, is_new] = first.emplace(parameter.name, &parameter);
    if (is_new || known->second->value.value == parameter.value.value) continue;
    context.report({.where = parameter.value.span,
                    .message = "<" + parameter.name + "> is given twice: '" +
                               known->second->value.value + "' is read, '" + parameter.value.value +
                               "' is ignored",
                    .subject = context.subject(plugin),
                    .related = {{known->second->value.span, "the first"}}});
  }
}

Rule rule() {
  return {
      .name = "plugin-parameter-repeated",
      .severity = Severity::kWarning,
      .summary = "a plugin parameter is given twice with different values",
      .why = "Gazebo's systems read the first element of a name and ignore those that follow: what "
             "was meant to replace a value has no effect.",
      .what_to_do = "Keep the value that is meant and remove the other.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_parameter_repeated
