// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_link_physics {

void check(const convert::Note& note, Context& context) {
  const bool lost = note.outcome == convert::Outcome::kLost;
  context.report(told(note, fmt::format("{} {}{}", note.written, whereabouts(note),
                                        lost ? ": URDF has no word for it" : "")));
}

Rule rule() {
  return {
      .name = "convert-link-physics",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "what a link says to the engine is not in the robot",
      .why =
          "Damping of a link's velocity, wind, kinematic motion, batteries, added mass: URDF has "
          "no word for them. A `<gazebo>` block carries the damping, which Gazebo reads.",
      .what_to_do = "Set them in the simulator where they matter.",
      .checks = {on_conversion({convert::NoteKind::kLinkPhysics}, check)},
  };
}

}  // namespace rigor::rules::convert_link_physics
