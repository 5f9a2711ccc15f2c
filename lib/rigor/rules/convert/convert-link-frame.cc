// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_link_frame {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("the link's frame moves to its joint, by {}", note.written)));
}

Rule rule() {
  return {
      .name = "convert-link-frame",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a link's frame moves to its joint",
      .why =
          "In URDF a link's frame is that of its joint. What the link holds is moved the other "
          "way, so that nothing moves; only the frame by the link's name is elsewhere.",
      .what_to_do =
          "Where code asks for the old frame, convert with `--keep-link-frames`: it stays as a "
          "link of its own.",
      .checks = {on_conversion({convert::NoteKind::kLinkFrame}, check)},
  };
}

}  // namespace rigor::rules::convert_link_frame
