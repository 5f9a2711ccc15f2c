// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_too_many_joints {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "the body has " + fact.detail + " degrees of freedom; 6 at most",
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-too-many-joints",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "more than six degrees of freedom in a body",
      .why = "MuJoCo rejects the file: a body has six degrees of freedom at most.",
      .what_to_do = "Remove joints, or put a body between them.",
      .checks = {on_mjcf({read::MjcfFactKind::kTooManyJoints}, check)},
  };
}

}  // namespace rigor::rules::mjcf_too_many_joints
