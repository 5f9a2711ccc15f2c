// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_orientation_zero {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where, .message = fact.name + " has no length", .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-orientation-zero",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "orientation of no length",
      .why = "MuJoCo rejects the file, or takes no rotation: a quaternion or an axis of zeros has "
             "no direction.",
      .what_to_do = "Write the axis or quaternion that is meant, or remove it.",
      .checks = {on_mjcf({read::MjcfFactKind::kOrientationZero}, check)},
  };
}

}  // namespace rigor::rules::mjcf_orientation_zero
