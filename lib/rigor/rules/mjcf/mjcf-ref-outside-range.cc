// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_ref_outside_range {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where, .message = "ref " + fact.detail, .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-ref-outside-range",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "position at rest is outside the range of the joint",
      .why = "MuJoCo puts the joint at ref when it begins, and the limit then pushes it "
             "back with a jerk.",
      .what_to_do = "Write a ref within the range, in the same unit.",
      .checks = {on_mjcf({read::MjcfFactKind::kRefOutside}, check)},
  };
}

}  // namespace rigor::rules::mjcf_ref_outside_range
