// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_actuator_two_targets {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = std::string("the actuator names more than one target"),
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-actuator-two-targets",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "actuator with two targets",
      .why = "MuJoCo before 3 rejects the file; newer versions take one of the targets and ignore "
             "the others: an actuator drives one joint, tendon, site or body.",
      .what_to_do = "Keep one of them.",
      .checks = {on_mjcf({read::MjcfFactKind::kActuatorTwoTargets}, check)},
  };
}

}  // namespace rigor::rules::mjcf_actuator_two_targets
