// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_not_the_same {

void check(const convert::Note& note, Context& context) {
  context.report(refused(note, fmt::format("not the same robot: {}", note.written)));
}

Rule rule() {
  return {
      .name = "convert-not-the-same",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "the result is another robot",
      .why =
          "What was written is read again and moved through random joint positions beside the "
          "source; here the two are not the same. Either a loss that was allowed shows, or rigor "
          "has an error.",
      .what_to_do = "Look at the losses above it; when there is none, please report it.",
      .checks = {on_conversion({convert::NoteKind::kNotTheSame}, check)},
  };
}

}  // namespace rigor::rules::convert_not_the_same
