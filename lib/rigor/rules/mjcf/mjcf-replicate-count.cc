// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_replicate_count {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where, .message = "the number of copies is wrong: " + fact.detail});
}

Rule rule() {
  return {
      .name = "mjcf-replicate-count",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "number of copies is not positive",
      .why = "MuJoCo rejects the file: <replicate> makes one copy or more.",
      .what_to_do = "Write the number of copies.",
      .checks = {on_mjcf({read::MjcfFactKind::kReplicateCount}, check)},
  };
}

}  // namespace rigor::rules::mjcf_replicate_count
