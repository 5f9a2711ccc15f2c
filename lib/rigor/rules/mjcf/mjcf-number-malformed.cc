// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_number_malformed {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = "'" + fact.detail + "' of " + fact.name + " is not a list of numbers"});
}

Rule rule() {
  return {
      .name = "mjcf-number-malformed",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "text where MuJoCo expects numbers",
      .why =
          "MuJoCo rejects the file: numbers are separated by spaces, with a point before decimals.",
      .what_to_do = "Write numbers, separated by spaces.",
      .checks = {on_mjcf({read::MjcfFactKind::kNumbersMalformed}, check)},
  };
}

}  // namespace rigor::rules::mjcf_number_malformed
