// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_redefined_builtin {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-redefined-builtin",
      .severity = Severity::kWarning,
      .summary = "a property has the name of a function or constant",
      .why = "From here on the function is out of reach: expressions that call it fail, or take "
             "the property's value instead. xacro prints a warning.",
      .what_to_do = "Give the property another name.",
      .checks = {on_xacro({FactKind::kRedefinedBuiltin}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_redefined_builtin
