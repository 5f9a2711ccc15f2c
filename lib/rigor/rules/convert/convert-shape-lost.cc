// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_shape_lost {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("there is no {} in the target: the shape is left out", note.written)));
}

Rule rule() {
  return {
      .name = "convert-shape-lost",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "a shape that the target lacks is left out",
      .why =
          "The link loses what it collides or is seen with. A robot that lost a collision falls "
          "through things.",
      .what_to_do =
          "Convert with `--shapes mesh`, which writes mesh files, or choose a shape that both "
          "formats have.",
      .checks = {on_conversion({convert::NoteKind::kShapeLost}, check)},
  };
}

}  // namespace rigor::rules::convert_shape_lost
