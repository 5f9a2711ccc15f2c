// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_safety {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("the safety controller ({}) is lost: SDF has none", note.written)));
}

Rule rule() {
  return {
      .name = "convert-safety",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a safety controller is lost",
      .why =
          "SDF has no soft limits of a joint: what kept the controller from running into the stops "
          "is gone.",
      .what_to_do = "Give the soft limits to the controller.",
      .checks = {on_conversion({convert::NoteKind::kSafety}, check)},
  };
}

}  // namespace rigor::rules::convert_safety
