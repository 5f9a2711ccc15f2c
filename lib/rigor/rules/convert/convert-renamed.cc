// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_renamed {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("{} is named {} in the result", note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-renamed",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a name was changed",
      .why =
          "The target does not take the name: it has it already for something else, or it stands "
          "for something special there.",
      .what_to_do =
          "Use the new name in controllers and launch files; `--report json:FILE` has the map.",
      .checks = {on_conversion({convert::NoteKind::kRenamed}, check)},
  };
}

}  // namespace rigor::rules::convert_renamed
