// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_wrong_type {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-wrong-type",
      .severity = Severity::kError,
      .summary = "a value is not what an operator, function or condition takes",
      .why = "A text where a number is due, as when `0.1 0.2` is multiplied: xacro ends with "
             "Python's TypeError or ValueError, so nothing is loaded.",
      .what_to_do =
          "Give a value of the kind that is expected; the place where the value is set is "
          "shown with the finding.",
      .checks = {on_xacro({FactKind::kWrongType, FactKind::kWrongValue, FactKind::kNotBoolean},
                          report_fact)},
  };
}

}  // namespace rigor::rules::xacro_wrong_type
