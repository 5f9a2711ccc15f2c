// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_angle_looks_like_degrees {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = fact.name + " " + fact.detail + " looks like degrees and is read in radians",
       .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-angle-looks-like-degrees",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "angle in degrees where radians are read",
      .why = "MuJoCo reads angles in radians where <compiler angle> says so: a joint may "
             "then turn many times, and a body is rotated at random.",
      .what_to_do = "Write the angle in radians, or remove angle=\"radian\" where all are "
                    "degrees.",
      .checks = {on_mjcf({read::MjcfFactKind::kDegrees}, check)},
  };
}

}  // namespace rigor::rules::mjcf_angle_looks_like_degrees
