// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_unused_macro {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-unused-macro",
      .severity = Severity::kInfo,
      .summary = "a macro is not called",
      .why = "A change of it does not change the robot, although it looks so. Often another name "
             "is used by mistake, or a value is written twice.",
      .what_to_do = "Remove it, or call it.",
      .checks = {on_xacro({FactKind::kUnusedMacro}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_unused_macro
