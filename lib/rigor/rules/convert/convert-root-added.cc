// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_root_added {

void check(const convert::Note& note, Context& context) {
  context.report(
      refused(note, fmt::format("{} links hang on no joint ({}): all are fixed to one root now",
                                note.count, note.written)));
}

Rule rule() {
  return {
      .name = "convert-root-added",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "several trees were fixed to one new root",
      .why = "A URDF robot is one tree. What was free to move apart is now one rigid base.",
      .what_to_do = "Mind it wherever the robot is simulated.",
      .checks = {on_conversion({convert::NoteKind::kRootAdded}, check)},
  };
}

}  // namespace rigor::rules::convert_root_added
