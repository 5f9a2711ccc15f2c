// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_range_ignored {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = fact.name + " has no effect: " + fact.detail,
                  .subject = fact.subject});
}

void check_unlimited(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = fact.name + " is written without " + fact.detail + ", and autolimits is false",
       .subject = fact.subject,
       .why = "MuJoCo rejects the file; versions before 3 ignore the range.",
       .severity = Severity::kError});
}

Rule rule() {
  return {
      .name = "mjcf-range-ignored",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "range without effect",
      .why = "MuJoCo ignores the range where limited is false: the joint or actuator has no "
             "limit. Where limited is not written while <compiler autolimits> is false, it rejects "
             "the file, and the finding is an error.",
      .what_to_do = "Remove the range, or write limited=\"true\".",
      .checks = {on_mjcf({read::MjcfFactKind::kRangeIgnored}, check),
                 on_mjcf({read::MjcfFactKind::kRangeUnlimited}, check_unlimited)},
  };
}

}  // namespace rigor::rules::mjcf_range_ignored
