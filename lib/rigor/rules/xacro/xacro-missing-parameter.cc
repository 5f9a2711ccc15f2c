// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_missing_parameter {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-missing-parameter",
      .severity = Severity::kError,
      .summary = "a call does not give a parameter that has no default",
      .why = "xacro ends with \"Undefined parameters\", so nothing is loaded.",
      .what_to_do = "Give the parameter in the call, or a default in `params`: `name:=value`.",
      .checks = {on_xacro({FactKind::kMissingParameter}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_missing_parameter
