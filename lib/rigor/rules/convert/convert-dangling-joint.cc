// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_dangling_joint {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("connects nothing: {}", note.written)));
}

Rule rule() {
  return {
      .name = "convert-dangling-joint",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "a joint has no link at one end",
      .why =
          "Its parent or child names nothing, or the child is the world. No consumer can build the "
          "joint.",
      .what_to_do = "Name two links of the model; the parent may be `world`.",
      .checks = {on_conversion({convert::NoteKind::kDanglingJoint}, check)},
  };
}

}  // namespace rigor::rules::convert_dangling_joint
