// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_joint_physics {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("{} is lost: URDF has no word for it", note.written)));
}

Rule rule() {
  return {
      .name = "convert-joint-physics",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "solver parameters of a joint are not in the robot",
      .why =
          "URDF says nothing of how a solver treats a joint, and Gazebo's blocks hold only some of "
          "it.",
      .what_to_do = "Set them in the simulator where they matter.",
      .checks = {on_conversion({convert::NoteKind::kPhysics}, check)},
  };
}

}  // namespace rigor::rules::convert_joint_physics
