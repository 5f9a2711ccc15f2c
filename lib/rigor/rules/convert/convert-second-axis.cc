// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_second_axis {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, std::string("a second axis on a joint of one degree of freedom is left out")));
}

Rule rule() {
  return {
      .name = "convert-second-axis",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a second axis on a joint that has one",
      .why =
          "A revolute or prismatic joint turns about `<axis>`; SDF readers pass over `<axis2>`, "
          "and so does the conversion.",
      .what_to_do = "Take it away, or make the joint a universal one.",
      .checks = {on_conversion({convert::NoteKind::kSecondAxis}, check)},
  };
}

}  // namespace rigor::rules::convert_second_axis
