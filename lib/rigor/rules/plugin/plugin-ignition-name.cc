// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_ignition_name {

constexpr std::pair<std::string_view, std::string_view> kRenamed[] = {
    {"ignition-gazebo", "gz-sim"},
    {"ignition::gazebo::", "gz::sim::"},
};

/// With the first of the old names in it replaced; nothing when there is none.
std::optional<std::string> renamed(std::string_view text) {
  for (const auto& [old, now] : kRenamed) {
    const std::size_t at = text.find(old);
    if (at == std::string_view::npos) continue;
    return std::string(text.substr(0, at)) + std::string(now) +
           std::string(text.substr(at + old.size()));
  }
  return std::nullopt;
}

void check(const model::Plugin& plugin, Context& context) {
  std::vector<Edit> edits;
  const model::Field<std::string>* first = nullptr;
  for (const auto* field : {&plugin.filename, &plugin.name}) {
    const auto now = renamed(field->value);
    if (!now) continue;
    if (first == nullptr) first = field;
    if (const auto written = renamed(context.bytes(field->span))) {
      edits.push_back({field->span, *written});
    }
  }
  if (first == nullptr) return;
  context.report({.where = first->span,
                  .message = "'" + first->value + "' is a name of Ignition Gazebo; it is now '" +
                             *renamed(first->value) + "'",
                  .subject = context.subject(plugin),
                  .fix = fix_of("write the new names", Applicability::kUnsafe, std::move(edits))});
}

Rule rule() {
  return {
      .name = "plugin-ignition-name",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .targets = {Target::kGzSim},
      .summary = "a plugin has the name it had when Gazebo was called Ignition",
      .why = "Since Garden the libraries are called gz-sim-… and the classes gz::sim::…. Gazebo "
             "still turns the old name of a library into the new one, with a warning; the old "
             "names of classes are aliases that are to be taken out. Fortress and older know only "
             "the old names.",
      .what_to_do = "Write the new names, if the file is not for Fortress.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_ignition_name
