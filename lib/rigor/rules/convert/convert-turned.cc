// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_turned {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("the joint is turned round, since {} has another parent: "
                                        "{}, the axis negated",
                                        note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-turned",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a joint hangs the other way round",
      .why =
          "A link of URDF has one parent. In SDF two joints may lead to one link and still close "
          "no "
          "loop; with parent and child swapped and the axis negated, the joint's positions mean "
          "what they meant.",
      .what_to_do = "Nothing; or swap parent and child in the source.",
      .checks = {on_conversion({convert::NoteKind::kTurned}, check)},
  };
}

}  // namespace rigor::rules::convert_turned
