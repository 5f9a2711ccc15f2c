// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <map>
#include <string_view>
#include <tuple>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_duplicate {

void check(const model::Root& root, Context& context) {
  const auto place = [&context](const model::Plugin& plugin) {
    // The bytes, since the same system twice with other parameters is how it drives two joints.
    return std::tuple(plugin.model, plugin.world, plugin.link, plugin.sensor,
                      std::string_view(plugin.gazebo_reference), context.bytes(plugin.site.span));
  };
  std::map<decltype(place(root.plugins.front())), const model::Plugin*> seen;
  for (const model::Plugin& plugin : root.plugins) {
    if (!root.own(plugin.site) || plugin.filename.value.empty()) continue;
    const auto [entry, first] = seen.emplace(place(plugin), &plugin);
    if (first) continue;
    context.report({.where = plugin.site.name,
                    .message = "the same plugin stands here twice: " + plugin.filename.value,
                    .subject = context.subject(plugin),
                    .related = {{entry->second->site.name, "the first one"}},
                    .fix = fix_of("remove the second", Applicability::kUnsafe,
                                  removed(context, plugin.site))});
  }
}

Rule rule() {
  return {
      .name = "plugin-duplicate",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the same plugin is loaded twice",
      .why = "Both run: commands are carried out twice, topics are published twice, or the second "
             "one fails to advertise them.",
      .what_to_do = "Take one of them out.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::plugin_duplicate
