// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_replicate_count {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where, .message = "<replicate> makes no copy: its count is below 1"});
}

Rule rule() {
  return {
      .name = "mjcf-replicate-count",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "number of copies is not positive",
      .why = "MuJoCo makes no copy: what is inside is no part of the model.",
      .what_to_do = "Write the number of copies.",
      .checks = {on_mjcf({read::MjcfFactKind::kReplicateCount}, check)},
  };
}

}  // namespace rigor::rules::mjcf_replicate_count
