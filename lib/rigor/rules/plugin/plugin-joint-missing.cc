// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/model/names.h>
#include <rigor/rules/plugin/parameters.h>
#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>
#include <rigor/xml/edit.h>

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

/// Whether nothing that the model includes is missing: a joint may be in it.
bool is_whole(model::Id<model::Model> id, const model::Root& root) {
  return std::none_of(root.includes.begin(), root.includes.end(),
                      [&](const model::Include& include) {
                        if (include.followed || !include.model) return false;
                        for (auto around = include.model; around; around = root[around].parent) {
                          if (around == id) return true;
                        }
                        return false;
                      });
}

/// Of a plugin that rigor does not know: what names a joint, a link or a frame by the parameter's own name.
bool may_name_part(std::string_view parameter) {
  for (const std::string_view word :
       {"oint", "link", "Link", "body", "Body", "frame", "Frame", "collision"}) {
    if (parameter.find(word) != parameter.npos) return true;
  }
  return false;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The same but for a letter within a word, or two that are exchanged. Numbers and letters that stand alone, as in
/// leg_2 and l_arm, tell parts apart.
bool is_slip_of(std::string_view name, std::string_view other) {
  constexpr std::size_t kMin = 6;
  if (name.size() < kMin || schema::edit_distance(name, other, 1) != 1) return false;
  const auto at = std::mismatch(name.begin(), name.end(), other.begin(), other.end()).first;
  const std::string_view longer = other.size() > name.size() ? other : name;
  const auto i = static_cast<std::size_t>(at - name.begin());
  if (!is_letter(longer[i])) return false;
  const bool begins = i == 0 || !is_letter(longer[i - 1]);
  const bool ends = i + 1 == longer.size() || !is_letter(longer[i + 1]);
  return !(begins && ends);
}

void check_unknown(const model::Plugin& plugin, const model::Parameter& given, Context& context) {
  const std::string& value = given.value.value;
  if (!may_name_part(given.name) || !context.may_suggest() || !given.children.empty()) return;
  const std::vector<std::string> names = context.frames().names().in({plugin.model, {}});
  context.compared(names.size());
  if (std::find(names.begin(), names.end(), value) != names.end()) return;
  for (const std::string& name : names) {
    if (!is_slip_of(value, name)) continue;
    context.report(with_nearest({.where = given.value.span,
                                 .message = "the plugin names '" + value +
                                            "', which is no link, joint or frame of the model",
                                 .subject = context.subject(plugin)},
                                value, names, context));
    return;
  }
}

/// The joints that move a link of this name, or the link that a joint of this name moves: it was named in place of
/// them. Nothing when there is none.
std::vector<std::string> named_in_place(model::Id<model::Model> scope, ParameterOf what,
                                        std::string_view name, const Context& context) {
  const model::Root& root = context.root();
  std::vector<std::string> meant;
  for (const auto id : root[scope].joints) {
    const model::Joint& joint = root[id];
    const bool joins = joint.child.value == name && joint.type != model::JointType::kFixed;
    if (what == ParameterOf::kJoint && joins) meant.push_back(joint.name.value);
    if (what == ParameterOf::kLink && joint.name.value == name) meant.push_back(joint.child.value);
  }
  return meant;
}

/// Names that may be meant, the likely ones alone where it is known what was named in place of them.
Finding with_meant(Finding finding, const model::Plugin& plugin, ParameterOf what,
                   const std::string& name, Context& context) {
  const std::vector<std::string> meant = named_in_place(plugin.model, what, name, context);
  if (meant.size() != 1) {
    const auto all = [&] { return context.frames().names().in({plugin.model, {}}); };
    return with_nearest(std::move(finding), name, all, context);
  }
  finding.cause = name;
  finding.help =
      what == ParameterOf::kJoint
          ? fmt::format("'{}' is a link, which the joint '{}' moves", name, meant.front())
          : fmt::format("'{}' is a joint, which moves the link '{}'", name, meant.front());
  if (context.bytes(finding.where) == name) {
    finding.fix = Fix{"name '" + meant.front() + "'",
                      Applicability::kUnsafe,
                      {{finding.where, xml::escaped(meant.front())}}};
  }
  return finding;
}

void check(const model::Root& root, Context& context) {
  const model::Names& names = context.frames().names();
  for (const model::Plugin& plugin : root.plugins) {
    if (!plugin.model || !root.own(plugin.site) || !is_whole(plugin.model, root)) continue;
    const std::string name = library(plugin.filename.value);
    for (const model::Parameter& child : plugin.parameters) {
      const auto parameter = std::find_if(
          std::begin(kPluginParameters), std::end(kPluginParameters),
          [&](const auto& known) { return known.library == name && known.element == child.name; });
      if (parameter == std::end(kPluginParameters)) {
        check_unknown(plugin, child, context);
        continue;
      }
      const std::string& value = child.value.value;
      const std::string_view inner = within(root[plugin.model], value);
      // Some plugins of ROS 1 take a list.
      if (value.empty() || value.find_first_of(", ") != std::string::npos) continue;
      if (exists(names, plugin.model, parameter->what, value)) continue;
      if (exists(names, plugin.model, parameter->what, inner)) continue;
      const char* kind = parameter->what == ParameterOf::kJoint ? "joint" : "link";
      context.report(with_meant(
          {.where = child.value.span,
           .message = fmt::format("the plugin needs the {} '{}', which the model does not have",
                                  kind, value),
           .subject = context.subject(plugin)},
          plugin, parameter->what, value, context));
    }
  }
}

Rule rule() {
  return {
      .name = "plugin-joint-missing",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a plugin names a joint or link that the model does not have",
      .why = "The plugin finds nothing to drive: it logs one line, if at all, and does nothing.",
      .what_to_do = "Name a joint or link of the model that the plugin is in.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::plugin_joint_missing
