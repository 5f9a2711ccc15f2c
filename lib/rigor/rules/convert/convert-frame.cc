// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_frame {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, note.instead.empty()
                                ? std::string("the frame is left out")
                                : fmt::format("the frame becomes {}", note.instead)));
}

Rule rule() {
  return {
      .name = "convert-frame",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a frame becomes a link on a fixed joint, or is left out",
      .why =
          "URDF has no frames of their own. A massless link on a fixed joint is what ROS tools "
          "read as a frame.",
      .what_to_do = "Nothing, or leave them out with `--frames drop`.",
      .checks = {on_conversion({convert::NoteKind::kFrame}, check)},
  };
}

}  // namespace rigor::rules::convert_frame
