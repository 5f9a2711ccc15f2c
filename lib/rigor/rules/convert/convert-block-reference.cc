// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_block_reference {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("the gazebo block of {} is lost: the robot has nothing of that name",
                             note.written)));
}

Rule rule() {
  return {
      .name = "convert-block-reference",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a gazebo block speaks of nothing",
      .why =
          "Its reference names neither a link nor a joint: Gazebo passes over it without a word, "
          "and so what it says is lost.",
      .what_to_do = "Put the name right.",
      .checks = {on_conversion({convert::NoteKind::kBlockReference}, check)},
  };
}

}  // namespace rigor::rules::convert_block_reference
