// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_effort_stand_in {

void check(const convert::Note& note, Context& context) {
  context.report(told(
      note, fmt::format("effort has no limit ({}): {} stands for it", note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-effort-stand-in",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a finite number stands for an unlimited effort",
      .why =
          "URDF demands an effort, urdfdom refuses `inf`, and 0 would mean to controllers that the "
          "joint cannot push.",
      .what_to_do = "Write the effort that the actuator really has.",
      .checks = {on_conversion({convert::NoteKind::kEffortStandIn}, check)},
  };
}

}  // namespace rigor::rules::convert_effort_stand_in
