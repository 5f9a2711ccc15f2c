// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_unknown_parameter {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-unknown-parameter",
      .severity = Severity::kError,
      .summary = "a call gives a parameter that the macro does not have",
      .why = "xacro ends with \"Invalid parameter\", so nothing is loaded. Often the macro has "
             "changed, or the name is misspelled.",
      .what_to_do = "Correct the name, or add the parameter to the `params` of the macro.",
      .checks = {on_xacro({FactKind::kUnknownParameter}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_unknown_parameter
