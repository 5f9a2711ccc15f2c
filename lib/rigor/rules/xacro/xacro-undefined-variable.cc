// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_undefined_variable {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-undefined-variable",
      .severity = Severity::kError,
      .summary = "$(env …) names an environment variable that is not set",
      .why = "xacro ends with \"environment variable is not set\". What loads on one machine "
             "does not on the next.",
      .what_to_do = "Use `$(optenv NAME default)`, or an argument with a default.",
      .checks = {on_xacro({FactKind::kUndefinedVariable}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_undefined_variable
