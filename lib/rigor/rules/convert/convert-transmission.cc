// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_transmission {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("transmission {} {}", note.written,
                             note.instead.empty() ? "is lost: SDF has none" : note.instead)));
}

Rule rule() {
  return {
      .name = "convert-transmission",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a transmission is lost",
      .why =
          "SDF has no transmissions: ros_control reads them from the robot description, which "
          "stays URDF.",
      .what_to_do = "Keep the URDF as the robot description.",
      .checks = {on_conversion({convert::NoteKind::kTransmission}, check)},
  };
}

}  // namespace rigor::rules::convert_transmission
