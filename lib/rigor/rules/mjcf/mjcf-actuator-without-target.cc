// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_actuator_without_target {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = std::string("the actuator drives no joint, tendon, site or body"),
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-actuator-without-target",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "actuator without a target",
      .why = "MuJoCo rejects the file: an actuator names what it drives.",
      .what_to_do = "Add joint, tendon, site or body.",
      .checks = {on_mjcf({read::MjcfFactKind::kActuatorNoTarget}, check)},
  };
}

}  // namespace rigor::rules::mjcf_actuator_without_target
