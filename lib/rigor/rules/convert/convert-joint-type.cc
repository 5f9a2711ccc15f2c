// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_joint_type {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("there is no {} joint in the target; with --allow-loss it becomes {}",
                             note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-joint-type",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "the target has no joint of this type, and others stand for it",
      .why =
          "URDF knows fixed, revolute, continuous and prismatic joints (and floating and planar "
          "ones, which most consumers leave out). A universal joint is exactly two revolute ones "
          "with a link of next to no mass between; other substitutes come near. Consumers see "
          "other joints "
          "by other names.",
      .what_to_do = "Look at what stands for it, then accept it with `--allow-loss`.",
      .checks = {on_conversion({convert::NoteKind::kJointType}, check)},
  };
}

}  // namespace rigor::rules::convert_joint_type
