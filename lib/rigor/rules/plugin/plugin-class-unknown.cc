// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_class_unknown {

constexpr std::string_view kNew = "gz::sim::systems::";
constexpr std::string_view kOld = "ignition::gazebo::systems::";

/// `v6::` in front of a class names it in one version.
std::string_view without_version(std::string_view name) {
  if (name.size() < 4 || name[0] != 'v' || name[1] < '0' || name[1] > '9') return name;
  const std::size_t end = name.find("::");
  return end == std::string_view::npos ? name : name.substr(end + 2);
}

void check(const model::Plugin& plugin, Context& context) {
  const GazeboSystem* const system = gazebo_system(plugin.filename.value);
  if (system == nullptr || system->classes.empty() || !plugin.name.written) return;
  const std::string_view name = plugin.name.value;
  std::string_view inner = name;
  std::string_view before =
      plugin.filename.value.find("ignition") == std::string::npos ? kNew : kOld;
  for (const std::string_view space : {kNew, kOld}) {
    if (!name.starts_with(space)) continue;
    before = space;
    inner = without_version(name.substr(space.size()));
  }
  if (inner.size() != name.size() && has_word(system->classes, inner)) return;

  std::vector<std::string> classes;
  some_word(system->classes, [&](std::string_view word) {
    classes.push_back(std::string(before) + std::string(word));
    return false;
  });
  std::string help = "it has " + classes.front();
  for (std::size_t i = 1; i < classes.size(); ++i) help += " and " + classes[i];
  std::optional<Fix> fix;
  // Beside plugins of classic the name is none of a class, and the library may be the slip.
  const auto is_classic = [](const model::Plugin& other) {
    return other.filename.value.starts_with("lib") && other.filename.value.ends_with(".so");
  };
  const auto& plugins = context.root().plugins;
  const bool classic = name.find("::") == std::string_view::npos &&
                       std::any_of(plugins.begin(), plugins.end(), is_classic);
  if (!classic && classes.size() == 1 && context.bytes(plugin.name.span) == name) {
    fix = Fix{"name its class", Applicability::kUnsafe, {{plugin.name.span, classes.front()}}};
  }
  context.report({.where = plugin.name.span.size() > 0 ? plugin.name.span : plugin.site.name,
                  .message = "the library '" + plugin.filename.value + "' has no class '" +
                             std::string(name) + "'",
                  .subject = context.subject(plugin),
                  .help = std::move(help),
                  .fix = std::move(fix)});
}

Rule rule() {
  return {
      .name = "plugin-class-unknown",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the name of a plugin is no class of its library",
      .why = "For Gazebo classic the name of a plugin was free. New Gazebo makes the class of that "
             "name; when the library has none, it writes \"could not instantiate from library\" to "
             "its log and runs without the system.",
      .what_to_do =
          "Write the class, such as gz::sim::systems::DiffDrive for gz-sim-diff-drive-system.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_class_unknown
