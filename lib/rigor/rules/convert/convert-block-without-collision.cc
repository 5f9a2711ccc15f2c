// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_block_without_collision {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("{} of a link without collision is lost", note.written)));
}

Rule rule() {
  return {
      .name = "convert-block-without-collision",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "friction of a link that collides with nothing",
      .why =
          "Friction and contact belong to collisions in SDF; the link has none, so there is "
          "nowhere to write them.",
      .what_to_do = "Give the link a collision, or take the block away.",
      .checks = {on_conversion({convert::NoteKind::kBlockWithoutCollision}, check)},
  };
}

}  // namespace rigor::rules::convert_block_without_collision
