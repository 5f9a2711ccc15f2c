// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_limit_inverted {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("limits {}: the lower one is above the upper one", note.written)));
}

Rule rule() {
  return {
      .name = "convert-limit-inverted",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "the lower limit is above the upper one",
      .why =
          "No position is allowed, and consumers differ: some swap the limits, some freeze the "
          "joint. No conversion of it is right.",
      .what_to_do = "Swap the limits.",
      .checks = {on_conversion({convert::NoteKind::kLimitInverted}, check)},
  };
}

}  // namespace rigor::rules::convert_limit_inverted
