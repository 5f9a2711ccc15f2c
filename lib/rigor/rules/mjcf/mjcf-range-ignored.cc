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

Rule rule() {
  return {
      .name = "mjcf-range-ignored",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "range without effect",
      .why = "MuJoCo ignores the range, or with autolimits off rejects the file: limited is false, "
             "or is not written while <compiler autolimits> is false. The joint or actuator has no "
             "limit.",
      .what_to_do = "Remove the range, or write limited=\"true\".",
      .checks = {on_mjcf({read::MjcfFactKind::kRangeIgnored}, check)},
  };
}

}  // namespace rigor::rules::mjcf_range_ignored
