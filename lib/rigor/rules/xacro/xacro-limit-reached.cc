// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_limit_reached {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-limit-reached",
      .severity = Severity::kError,
      .summary = "an expansion exceeds a limit",
      .why = "A macro that calls itself without end takes all memory of whatever expands it; "
             "xacro ends when Python's stack does.",
      .what_to_do = "End the recursion with a condition, or make the values smaller.",
      .checks = {on_xacro({FactKind::kBoundReached}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_limit_reached
