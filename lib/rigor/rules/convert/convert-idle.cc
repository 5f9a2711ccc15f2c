// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_idle {

void check(const convert::Note& note, Context& context) {
  context.report(refused(
      note, fmt::format("{}: no reader takes it, so the result does not say it", note.written)));
}

Rule rule() {
  return {
      .name = "convert-idle",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "something without effect is not carried",
      .why =
          "What a fixed joint says of its axis, or a collision of its colour, no reader takes: the "
          "robot is the same without it.",
      .what_to_do = "Nothing; or take it out of the source.",
      .checks = {on_conversion({convert::NoteKind::kIdle}, check)},
  };
}

}  // namespace rigor::rules::convert_idle
