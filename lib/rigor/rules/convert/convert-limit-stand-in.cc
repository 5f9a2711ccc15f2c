// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_limit_stand_in {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("no limit ({}): {} stands for it", note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-limit-stand-in",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "a finite number stands for a limit that is none",
      .why =
          "URDF wants both limits of a prismatic or half-limited joint, and urdfdom refuses `inf`. "
          "The number is far beyond what any robot reaches, but planners see a limit.",
      .what_to_do = "Write the limit that the joint really has.",
      .checks = {on_conversion({convert::NoteKind::kLimitStandIn}, check)},
  };
}

}  // namespace rigor::rules::convert_limit_stand_in
