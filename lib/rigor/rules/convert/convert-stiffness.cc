// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_stiffness {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("{} is lost: URDF has hard limits only", note.written)));
}

Rule rule() {
  return {
      .name = "convert-stiffness",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "how stiff a joint's stops are is not in the robot",
      .why = "URDF's limits are hard: it has no stiffness and no dissipation of a stop.",
      .what_to_do = "Set them in the simulator where they matter.",
      .checks = {on_conversion({convert::NoteKind::kStiffness}, check)},
  };
}

}  // namespace rigor::rules::convert_stiffness
