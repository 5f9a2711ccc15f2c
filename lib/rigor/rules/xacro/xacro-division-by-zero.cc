// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_division_by_zero {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-division-by-zero",
      .severity = Severity::kError,
      .summary = "an expression divides by zero",
      .why = "xacro ends with \"division by zero\", so nothing is loaded.",
      .what_to_do = "Give the divisor another value, or guard the division with `xacro:if`.",
      .checks = {on_xacro({FactKind::kDivisionByZero}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_division_by_zero
