// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_parameter_unknown {

/// What the plugin reads, and what its ancestor in gazebo_ros read.
struct Known {
  std::string_view parameters;
  std::string_view former;
};

std::optional<Known> known_by(std::string_view file) {
  if (const GazeboSystem* system = gazebo_system(file)) {
    if (system->parameters.empty()) return std::nullopt;
    for (const GazeboRosParameters& ros : kGazeboRosParameters) {
      if (ros.system == system->library) return Known{system->parameters, ros.parameters};
    }
    return Known{system->parameters, {}};
  }
  constexpr std::string_view kRos = "libgazebo_ros_";
  if (!file.starts_with(kRos) || !file.ends_with(".so")) return std::nullopt;
  const std::string_view name = file.substr(kRos.size(), file.size() - kRos.size() - 3);
  for (const GazeboRosParameters& ros : kGazeboRosParameters) {
    if (ros.plugin == name) return Known{ros.parameters, {}};
  }
  return std::nullopt;
}

std::vector<std::string_view> missing_from(const model::Plugin& plugin,
                                           std::string_view parameters) {
  std::vector<std::string_view> names;
  some_word(parameters, [&](std::string_view word) {
    if (find(plugin.parameters, word) == nullptr) names.push_back(word);
    return false;
  });
  return names;
}

/// All that is left of the ancestor's is one fault: only the name of the library was changed.
void report_former(const std::vector<const model::Parameter*>& former, const model::Plugin& plugin,
                   Context& context) {
  constexpr std::size_t kMaxNamed = 4;  // a longer list is not read
  std::vector<std::string_view> names;
  for (const model::Parameter* parameter : former) {
    if (std::find(names.begin(), names.end(), parameter->name) != names.end()) continue;
    names.emplace_back(parameter->name);
  }
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNamed); ++i) {
    list += (i == 0 ? "<" : ", <") + std::string(names[i]) + ">";
  }
  if (names.size() > kMaxNamed) list += fmt::format(" and {} more", names.size() - kMaxNamed);
  context.report({.where = former.front()->site.name,
                  .message = "the plugin does not read " + list +
                             ", which the plugin of gazebo_ros that did the same read",
                  .subject = context.subject(plugin)});
}

void check(const model::Plugin& plugin, Context& context) {
  const auto known = known_by(plugin.filename.value);
  if (!known) return;
  std::vector<const model::Parameter*> former;
  std::optional<std::vector<std::string_view>> candidates;
  for (const model::Parameter& given : plugin.parameters) {
    const std::string_view name = given.name;
    if (has_word(known->parameters, name) || name.find(':') != std::string_view::npos) continue;
    if (has_word(known->former, name)) {
      former.push_back(&given);
      continue;
    }
    if (!context.may_suggest()) return;
    // What stands there already was not meant.
    if (!candidates) candidates = missing_from(plugin, known->parameters);
    context.compared(candidates->size());
    const auto near = schema::near(name, *candidates);
    if (near.empty()) continue;  // perhaps a later version reads it
    const std::string meant(near.front());
    std::optional<Fix> fix;
    if (near.size() == 1) {
      fix = fix_of("call it '" + meant + "'", Applicability::kUnsafe,
                   renamed(context, given.site, meant));
    }
    context.report({.where = given.site.name,
                    .message = "the plugin does not read <" + std::string(name) + ">",
                    .subject = context.subject(plugin),
                    .help = "did you mean '" + meant + "'?",
                    .fix = std::move(fix)});
  }
  if (!former.empty()) report_former(former, plugin, context);
}

Rule rule() {
  return {
      .name = "plugin-parameter-unknown",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a plugin is given a parameter that it does not read",
      .why = "Plugins read the names they know and ignore all others silently: the value has no "
             "effect, and a default is used. rigor knows the parameters of the most common systems "
             "of Gazebo, and reports a name only when it is nearly one of them, or one of the "
             "corresponding plugin of gazebo_ros.",
      .what_to_do = "Write the name as the documentation of the plugin has it.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_parameter_unknown
