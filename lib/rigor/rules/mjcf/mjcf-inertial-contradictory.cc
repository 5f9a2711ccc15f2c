// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_inertial_contradictory {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where, .message = fact.detail});
}

Rule rule() {
  return {
      .name = "mjcf-inertial-contradictory",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "inertial is written in two ways",
      .why = "MuJoCo rejects the file: fullinertia is given along the axes of the body, and "
             "excludes diaginertia and an orientation.",
      .what_to_do = "Keep one of them.",
      .checks = {on_mjcf({read::MjcfFactKind::kInertialIncomplete}, check)},
  };
}

}  // namespace rigor::rules::mjcf_inertial_contradictory
