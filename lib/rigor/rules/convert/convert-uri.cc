// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_uri {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("{} becomes {}", note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-uri",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a mesh is named in the target's own way",
      .why = "ROS tools find meshes by `package://`, Gazebo by `model://`.",
      .what_to_do = "Choose with `--mesh-uri package://NAME`, `file` or `keep`.",
      .checks = {on_conversion({convert::NoteKind::kUri}, check)},
  };
}

}  // namespace rigor::rules::convert_uri
