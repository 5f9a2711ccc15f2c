// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_free_joint_not_alone {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = std::string("a free joint is beside another joint"),
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-free-joint-not-alone",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "free joint beside another joint",
      .why = "MuJoCo rejects the file: a free joint has all six degrees of freedom of its body.",
      .what_to_do = "Keep one of the joints.",
      .checks = {on_mjcf({read::MjcfFactKind::kFreeJointNotAlone}, check)},
  };
}

}  // namespace rigor::rules::mjcf_free_joint_not_alone
