// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_unresolved {

void check(const convert::Note& note, Context& context) {
  context.report(
      refused(note, fmt::format("{} leads nowhere: the robot cannot be told", note.written)));
}

Rule rule() {
  return {
      .name = "convert-unresolved",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "a reference or an include leads nowhere",
      .why =
          "Where a part of the model cannot be found or placed, any robot that is written would be "
          "another one.",
      .what_to_do = "Put the reference right; `rigor validate` says what was tried.",
      .checks = {on_conversion({convert::NoteKind::kUnresolved}, check)},
  };
}

}  // namespace rigor::rules::convert_unresolved
