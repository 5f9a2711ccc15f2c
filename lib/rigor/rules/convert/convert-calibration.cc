// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_calibration {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, std::string("the calibration is lost: SDF has none")));
}

Rule rule() {
  return {
      .name = "convert-calibration",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kUrdf,
      .summary = "a joint's calibration is lost",
      .why = "SDF has no reference positions of a joint.",
      .what_to_do = "Give them to the driver.",
      .checks = {on_conversion({convert::NoteKind::kCalibration}, check)},
  };
}

}  // namespace rigor::rules::convert_calibration
