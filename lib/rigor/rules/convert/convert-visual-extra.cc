// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_visual_extra {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("{} is lost: URDF has no word for it", note.written)));
}

Rule rule() {
  return {
      .name = "convert-visual-extra",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "what a visual says to the renderer is lost",
      .why = "Shadows, layers, visibility flags and retro-reflection have no place in URDF.",
      .what_to_do = "Set them in the simulator where they matter.",
      .checks = {on_conversion({convert::NoteKind::kVisualExtra}, check)},
  };
}

}  // namespace rigor::rules::convert_visual_extra
