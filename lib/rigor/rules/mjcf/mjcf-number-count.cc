// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_number_count {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where, .message = fact.name + " takes " + fact.detail});
}

Rule rule() {
  return {
      .name = "mjcf-number-count",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "too few or too many numbers",
      .why = "MuJoCo rejects the file: it has too few numbers, or more than the attribute takes.",
      .what_to_do = "Write as many numbers as the attribute takes.",
      .checks = {on_mjcf({read::MjcfFactKind::kNumbersCount}, check)},
  };
}

}  // namespace rigor::rules::mjcf_number_count
