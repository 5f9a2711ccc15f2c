// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_undefined_argument {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-undefined-argument",
      .severity = Severity::kError,
      .summary = "an argument has neither a value nor a default",
      .why = "xacro ends with \"Undefined substitution argument\" whenever the launch file does "
             "not give a value, so nothing is loaded.",
      .what_to_do =
          "Declare it with `<xacro:arg name=\"…\" default=\"…\"/>` before it is used, or give"
          " a value: name:=value.",
      .checks = {on_xacro({FactKind::kUndefinedArgument}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_undefined_argument
