// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_not_carried {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("{} is not in the result", note.written)));
}

Rule rule() {
  return {
      .name = "convert-not-carried",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "an element that the conversion has no rule for",
      .why = "What has no rule is a loss: the result does not say it.",
      .what_to_do = "Look whether the result needs it.",
      .checks = {on_conversion({convert::NoteKind::kUnknown}, check)},
  };
}

}  // namespace rigor::rules::convert_not_carried
