// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_gimbal {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("pitch is ±90°: the same rotation is written as {}", note.instead)));
}

Rule rule() {
  return {
      .name = "convert-gimbal",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "at a pitch of 90° roll and yaw are one turn",
      .why =
          "Roll-pitch-yaw angles are not unique there. Roll is written as 0 and yaw takes the "
          "whole turn: the rotation is the same to the last digits.",
      .what_to_do = "Nothing: the rotation is the same.",
      .checks = {on_conversion({convert::NoteKind::kGimbal}, check)},
  };
}

}  // namespace rigor::rules::convert_gimbal
