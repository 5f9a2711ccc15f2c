// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_static {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("static {}", note.instead.empty() ? whereabouts(note)
                                                               : "becomes " + note.instead)));
}

Rule rule() {
  return {
      .name = "convert-static",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "that a model never moves is told in another way",
      .why =
          "URDF has no word for a model that never moves. A fixed joint to a link named world says "
          "the same; a `<gazebo>` block says it to Gazebo alone.",
      .what_to_do = "Nothing, or fix it to the world for all: `--static world-link`.",
      .checks = {on_conversion({convert::NoteKind::kStatic}, check)},
  };
}

}  // namespace rigor::rules::convert_static
