// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_degrees {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-degrees",
      .severity = Severity::kWarning,
      .summary = "a trigonometric function is given degrees",
      .why = "`sin(90)` is 0.894, not 1. sin, cos and tan take radians.",
      .what_to_do = "Write `sin(radians(90))`, or the angle in radians.",
      .checks = {on_xacro({FactKind::kDegrees}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_degrees
