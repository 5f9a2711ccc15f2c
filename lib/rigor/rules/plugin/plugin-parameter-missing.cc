// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::plugin_parameter_missing {

/// A parameter whose name is misspelt is not missing: plugin-parameter-unknown reports it.
bool is_misspelt_in(const model::Plugin& plugin, std::string_view parameter,
                    std::string_view parameters) {
  for (const model::Parameter& given : plugin.parameters) {
    if (has_word(parameters, given.name)) continue;
    if (!schema::near(given.name, {parameter}).empty()) return true;
  }
  return false;
}

void check(const model::Plugin& plugin, Context& context) {
  const GazeboSystem* const system = gazebo_system(plugin.filename.value);
  if (system == nullptr || system->required.empty()) return;
  std::string missing;
  some_word(system->required, [&](std::string_view parameter) {
    const bool given = find(plugin.parameters, parameter) != nullptr;
    if (!given && !is_misspelt_in(plugin, parameter, system->parameters)) {
      missing += (missing.empty() ? "<" : ", <") + std::string(parameter) + ">";
    }
    return false;
  });
  if (missing.empty()) return;
  context.report({.where = plugin.site.name,
                  .message = "the plugin needs " + missing + ", which it is not given",
                  .subject = context.subject(plugin)});
}

Rule rule() {
  return {
      .name = "plugin-parameter-missing",
      .severity = Severity::kWarning,
      .summary = "required plugin parameter is missing",
      .why = "The systems of Gazebo that drive a joint or push a link need its name. Without it "
             "they write a line to the log, if at all, and do nothing: commands that are sent to "
             "them have no effect.",
      .what_to_do = "Name the joint or link, or remove the plugin.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_parameter_missing
