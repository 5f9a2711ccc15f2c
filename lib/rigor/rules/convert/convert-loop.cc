// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_loop {

void check(const convert::Note& note, Context& context) {
  context.report(told(
      note, fmt::format(
                "closes a loop: {} already hangs on {}; URDF has trees only, so this joint is cut",
                note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-loop",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "a link has a second parent, and its joint is cut",
      .why =
          "URDF has trees only: urdfdom refuses or hangs on a link with two parents. Without the "
          "joint the mechanism moves otherwise: a closed gripper opens, a parallel leg falls "
          "apart.",
      .what_to_do =
          "Close the loop in the simulator (a constraint, a mimic joint), or accept the cut with "
          "`--allow-loss`.",
      .checks = {on_conversion({convert::NoteKind::kLoop}, check)},
  };
}

}  // namespace rigor::rules::convert_loop
