// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_velocity_stand_in {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("velocity has no limit ({}): {} stands for it",
                                        note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-velocity-stand-in",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a finite number stands for an unlimited velocity",
      .why =
          "URDF demands a velocity, urdfdom refuses `inf`, and 0 would mean to planners that the "
          "joint cannot move.",
      .what_to_do = "Write the velocity that the actuator really reaches.",
      .checks = {on_conversion({convert::NoteKind::kVelocityStandIn}, check)},
  };
}

}  // namespace rigor::rules::convert_velocity_stand_in
