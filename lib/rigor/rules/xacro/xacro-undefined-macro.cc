// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_undefined_macro {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-undefined-macro",
      .severity = Severity::kError,
      .summary = "a call names a macro that is undefined",
      .why = "xacro ends with \"unknown macro name\", so nothing is loaded. A macro is known "
             "from its definition on; what is called before the file that defines it is included"
             " is unknown.",
      .what_to_do =
          "Correct the name, or include the file that defines the macro before it is called.",
      .checks = {on_xacro({FactKind::kUndefinedMacro}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_undefined_macro
