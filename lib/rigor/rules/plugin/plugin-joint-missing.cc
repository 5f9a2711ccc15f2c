// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <variant>

#include <fmt/core.h>

#include <rigor/model/names.h>
#include <rigor/rules/plugin/parameters.h>
#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_joint_missing {

std::string library(std::string_view file) {
  if (file.starts_with("lib")) file.remove_prefix(3);
  if (file.ends_with(".so")) file.remove_suffix(3);
  constexpr std::string_view kOld = "ignition-gazebo-";
  if (file.starts_with(kOld)) return "gz-sim-" + std::string(file.substr(kOld.size()));
  return std::string(file);
}

bool exists(const model::Names& names, model::Id<model::Model> scope, ParameterOf what,
            std::string_view name) {
  const model::Named named = names.find({scope, {}}, name);
  if (what == ParameterOf::kJoint) {
    return names.find_joint(scope, name) || std::holds_alternative<model::Id<model::Joint>>(named);
  }
  return names.find_link(scope, name) || std::holds_alternative<model::Id<model::Link>>(named);
}

/// Gazebo classic also takes names that begin with the model's own.
std::string_view within(const model::Model& model, std::string_view name) {
  const std::string own = model.name.value + "::";
  return name.starts_with(own) ? name.substr(own.size()) : name;
}

bool is_whole(const model::Root& root) {
  return std::all_of(root.includes.begin(), root.includes.end(),
                     [](const model::Include& include) { return include.followed; });
}

void check(const model::Root& root, Context& context) {
  if (!is_whole(root)) return;  // a joint may be in what was not found
  const model::Names& names = context.frames().names();
  for (const model::Plugin& plugin : root.plugins) {
    if (!plugin.model || !root.own(plugin.site)) continue;
    const std::string name = library(plugin.filename.value);
    for (const model::Parameter& child : plugin.parameters) {
      const auto parameter = std::find_if(
          std::begin(kPluginParameters), std::end(kPluginParameters),
          [&](const auto& known) { return known.library == name && known.element == child.name; });
      if (parameter == std::end(kPluginParameters)) continue;
      const std::string& value = child.value.value;
      const std::string_view inner = within(root[plugin.model], value);
      // Some plugins of ROS 1 take a list.
      if (value.empty() || value.find_first_of(", ") != std::string::npos) continue;
      if (exists(names, plugin.model, parameter->what, value)) continue;
      if (exists(names, plugin.model, parameter->what, inner)) continue;
      const auto all = [&] { return names.in({plugin.model, {}}); };
      const char* kind = parameter->what == ParameterOf::kJoint ? "joint" : "link";
      context.report(
          with_nearest({.where = child.value.span,
                        .message = fmt::format("the plugin needs the {} '{}', which the model does "
                                               "not have",
                                               kind, value),
                        .subject = context.subject(plugin)},
                       value, all, context));
    }
  }
}

Rule rule() {
  return {
      .name = "plugin-joint-missing",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a plugin names a joint or link that the model does not have",
      .why = "The plugin finds nothing to drive: it says so in a line of the simulator's log, if "
             "at all, and does nothing.",
      .what_to_do = "Name a joint or link of the model that the plugin stands in.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::plugin_joint_missing
