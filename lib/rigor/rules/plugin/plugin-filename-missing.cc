// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_filename_missing {
namespace {

void check(const model::Plugin& plugin, Context& context) {
  const auto& file = plugin.filename;
  if (!file.written || !file.value.empty()) return;  // the schema's rules name a missing attribute
  context.report({.where = file.span.size() > 0 ? file.span : plugin.site.name,
                  .message = "the plugin '" + plugin.name.value + "' names no library",
                  .subject = context.subject(plugin)});
}

}  // namespace

Rule rule() {
  return {
      .name = "plugin-filename-missing",
      .category = Category::kPlugin,
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .summary = "a plugin names no library",
      .why = "libsdformat refuses the file: the filename is required, and must not be empty.",
      .what_to_do = "Name the library, such as gz-sim-diff-drive-system, or take the plugin out.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <«plugin» name="drive" filename="">
    </plugin>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <plugin name="drive" filename="gz-sim-diff-drive-system">
    </plugin>
  </model>
</sdf>
)"}},
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::plugin_filename_missing
