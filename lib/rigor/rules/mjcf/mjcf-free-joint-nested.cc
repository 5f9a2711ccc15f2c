// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_free_joint_nested {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = std::string("a free joint is in a body that is not a child of the world"),
       .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-free-joint-nested",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "free joint below the top level",
      .why = "MuJoCo rejects the file: only a child of the world can be free.",
      .what_to_do = "Move the body to the top level, or use other joints.",
      .checks = {on_mjcf({read::MjcfFactKind::kFreeJointNested}, check)},
  };
}

}  // namespace rigor::rules::mjcf_free_joint_nested
