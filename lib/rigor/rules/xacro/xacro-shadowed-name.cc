// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_shadowed_name {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-shadowed-name",
      .severity = Severity::kInfo,
      .summary = "a property in a macro hides one of an outer scope",
      .why = "The outer property keeps its value: what was meant to change it changes a copy "
             "that is gone when the macro ends.",
      .what_to_do =
          "Give it another name, or say `scope=\"parent\"` or `scope=\"global\"` where the "
          "outer one is meant.",
      .checks = {on_xacro({FactKind::kShadowedName}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_shadowed_name
