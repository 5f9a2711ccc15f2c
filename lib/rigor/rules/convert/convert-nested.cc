// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_nested {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("nested model {} was flattened: its parts are named {}",
                                        note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-nested",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a nested model was flattened",
      .why =
          "URDF has no models in models: their links and joints become the robot's own, with the "
          "model's name in front.",
      .what_to_do =
          "Use the new names in controllers and launch files; `--report json:FILE` has the map.",
      .checks = {on_conversion({convert::NoteKind::kNested}, check)},
  };
}

}  // namespace rigor::rules::convert_nested
