// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_target_rejected {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where, .message = fact.detail, .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-target-rejected",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "reference to an element of the wrong kind",
      .why = "MuJoCo rejects the file: the element that is named exists, and is not one "
             "that can be used there.",
      .what_to_do = "Name another element, or use another sensor, constraint or actuator.",
      .checks = {on_mjcf({read::MjcfFactKind::kTargetRejected}, check)},
  };
}

}  // namespace rigor::rules::mjcf_target_rejected
