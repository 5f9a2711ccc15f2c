// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_axis_unit {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("axis {} is written as a unit vector", note.written)));
}

Rule rule() {
  return {
      .name = "convert-axis-unit",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "an axis was made a unit vector",
      .why =
          "Gazebo normalises axes; some readers of URDF do not, and would move a prismatic joint "
          "twice as far along an axis of length 2.",
      .what_to_do = "Nothing: the axis is the same.",
      .checks = {on_conversion({convert::NoteKind::kAxisUnit}, check)},
  };
}

}  // namespace rigor::rules::convert_axis_unit
