// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_actuator_no_effect {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "the actuator has no effect: " + fact.detail,
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-actuator-no-effect",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "actuator without effect",
      .why = "MuJoCo loads the model, and the actuator applies no force whatever its control is.",
      .what_to_do = "Write the gear, gain or range that is meant, or remove the actuator.",
      .checks = {on_mjcf({read::MjcfFactKind::kActuatorNoEffect}, check)},
  };
}

}  // namespace rigor::rules::mjcf_actuator_no_effect
