// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_continuous {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, std::string("revolute without limits: continuous in URDF")));
}

Rule rule() {
  return {
      .name = "convert-continuous",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a revolute joint without limits is a continuous one",
      .why = "SDF and URDF say the same in other words.",
      .what_to_do = "Nothing: the joint is the same.",
      .checks = {on_conversion({convert::NoteKind::kContinuous}, check)},
  };
}

}  // namespace rigor::rules::convert_continuous
