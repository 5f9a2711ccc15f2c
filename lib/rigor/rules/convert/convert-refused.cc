// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_refused {

void check(const convert::Note& note, Context& context) {
  context.report(refused(note, fmt::format("urdfdom refuses the result: {}", note.written)));
}

Rule rule() {
  return {
      .name = "convert-refused",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "the official parser refuses the result",
      .why = "Whatever reads the file next will refuse it as well.",
      .what_to_do = "Please report it, with the file.",
      .checks = {on_conversion({convert::NoteKind::kRefused}, check)},
  };
}

}  // namespace rigor::rules::convert_refused
