// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_inertial_automatic {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("auto inertial: {} is written", note.instead)));
}

Rule rule() {
  return {
      .name = "convert-inertial-automatic",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a computed inertial is written out",
      .why =
          "SDF 1.11 can leave the inertial to the simulator; URDF wants numbers. They are computed "
          "from the collisions as the simulator would.",
      .what_to_do = "Nothing: the inertial is the same.",
      .checks = {on_conversion({convert::NoteKind::kInertialAutomatic}, check)},
  };
}

}  // namespace rigor::rules::convert_inertial_automatic
