// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_axis_zero {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("the axis{} has no direction",
                                        note.written.empty() ? "" : " " + note.written)));
}

Rule rule() {
  return {
      .name = "convert-axis-zero",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "an axis has no direction",
      .why =
          "An axis of zeros turns about nothing: consumers refuse it, or choose an axis of their "
          "own.",
      .what_to_do = "Write the direction of the axis.",
      .checks = {on_conversion({convert::NoteKind::kAxisZero}, check)},
  };
}

}  // namespace rigor::rules::convert_axis_zero
