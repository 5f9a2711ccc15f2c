// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_library_misspelt {

/// What stands before the name that differs, the name, what stands behind it, and what it can be.
struct Misspelt {
  std::string before;
  std::string_view name;
  std::string after;
  std::vector<std::string> candidates;
};

std::optional<Misspelt> of_gazebo(std::string_view file) {
  const auto parts = gazebo_system(file) == nullptr ? system_file(file) : std::nullopt;
  if (!parts || parts->name.empty()) return std::nullopt;
  Misspelt misspelt{std::string(parts->before) + std::string(parts->prefix),
                    parts->name,
                    std::string(parts->after),
                    {}};
  for (const GazeboSystem& system : kGazeboSystems) {
    misspelt.candidates.push_back(std::string(system.library) + "-system");
  }
  return misspelt;
}

std::optional<Misspelt> of_gazebo_ros(std::string_view file) {
  constexpr std::string_view kRos = "libgazebo_ros_";
  constexpr std::string_view kEnd = ".so";
  if (!file.starts_with(kRos) || !file.ends_with(kEnd)) return std::nullopt;
  const std::string_view name = file.substr(kRos.size(), file.size() - kRos.size() - kEnd.size());
  if (std::find(std::begin(kGazeboRosPlugins), std::end(kGazeboRosPlugins), name) !=
      std::end(kGazeboRosPlugins)) {
    return std::nullopt;
  }
  return Misspelt{std::string(kRos),
                  name,
                  std::string(kEnd),
                  {std::begin(kGazeboRosPlugins), std::end(kGazeboRosPlugins)}};
}

void check(const model::Plugin& plugin, Context& context) {
  const std::string& file = plugin.filename.value;
  auto misspelt = of_gazebo(file);
  if (!misspelt) misspelt = of_gazebo_ros(file);
  if (!misspelt || !context.may_suggest()) return;
  const auto& candidates = misspelt->candidates;
  context.compared(candidates.size());
  std::string meant;
  const std::string with_end = std::string(misspelt->name) + "-system";
  if (std::find(candidates.begin(), candidates.end(), with_end) != candidates.end()) {
    meant = with_end;
  } else {
    const auto near = schema::near(misspelt->name, {candidates.begin(), candidates.end()});
    if (near.empty()) return;  // a plugin of the user's own
    meant = near.front();
  }
  meant = misspelt->before + meant + misspelt->after;
  const Span where = plugin.filename.span;
  std::optional<Fix> fix;
  if (context.bytes(where) == file) {
    fix = Fix{"name '" + meant + "'", Applicability::kUnsafe, {{where, meant}}};
  }
  context.report({.where = where,
                  .message = "there is no library '" + file + "' in Gazebo",
                  .subject = context.subject(plugin),
                  .help = "did you mean '" + meant + "'?",
                  .fix = std::move(fix)});
}

Rule rule() {
  return {
      .name = "plugin-library-misspelt",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a plugin names a library that is nearly one of Gazebo's",
      .why = "Gazebo finds no such library, writes a line to its log and runs without the plugin. "
             "Names that are not near to those of gz-sim or gazebo_ros_pkgs are taken for other "
             "plugins, and not reported.",
      .what_to_do = "Write the name of the library.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_library_misspelt
