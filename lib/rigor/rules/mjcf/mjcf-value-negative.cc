// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_value_negative {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = fact.name + " is negative: " + fact.detail,
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-value-negative",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "negative damping, friction, stiffness, armature or gain",
      .why = "MuJoCo takes the sign as it is: a negative damping, stiffness or gain "
             "drives the joint instead of holding it, and the simulation diverges; "
             "negative friction or armature makes the mass matrix or the constraint "
             "unsolvable.",
      .what_to_do = "Write a number of at least 0.",
      .checks = {on_mjcf({read::MjcfFactKind::kNegative}, check)},
  };
}

}  // namespace rigor::rules::mjcf_value_negative
