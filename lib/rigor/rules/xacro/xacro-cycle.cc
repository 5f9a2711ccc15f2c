// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_cycle {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-cycle",
      .severity = Severity::kError,
      .summary = "properties or files need each other",
      .why = "Properties are evaluated when they are first used: one that needs itself has no "
             "value, and xacro ends with \"recursive variable definition\". Files that include "
             "each other have no end.",
      .what_to_do =
          "Break the cycle: define one of the properties without the other, or move what both"
          " files need into a third.",
      .checks = {on_xacro({FactKind::kCycle, FactKind::kIncludeCycle}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_cycle
