// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_plugin {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("the plugin {}", whereabouts(note))));
}

Rule rule() {
  return {
      .name = "convert-plugin",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a plugin is for Gazebo only",
      .why =
          "A `<gazebo>` block carries the plugin as it is. The names of links and joints in it are "
          "the source's.",
      .what_to_do = "Look at the names in it when links or joints were renamed.",
      .checks = {on_conversion({convert::NoteKind::kPlugin}, check)},
  };
}

}  // namespace rigor::rules::convert_plugin
