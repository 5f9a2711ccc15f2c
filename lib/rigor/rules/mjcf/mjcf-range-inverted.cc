// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_range_inverted {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = fact.name + " " + fact.detail + ": the first number is not below the second",
       .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-range-inverted",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "range is inverted or empty",
      .why =
          "With limited=\"true\" MuJoCo rejects the file; else it ignores the range, and there is "
          "no limit. The first number of a range must be below the second.",
      .what_to_do = "Swap the numbers; where none are meant, remove the range.",
      .checks = {on_mjcf({read::MjcfFactKind::kRangeInverted}, check)},
  };
}

}  // namespace rigor::rules::mjcf_range_inverted
