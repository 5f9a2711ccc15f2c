// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_limited_without_range {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "limited, but " + fact.name + " is not written",
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-limited-without-range",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "limited without a range",
      .why =
          "MuJoCo rejects the file: a range that counts must not be empty, and 0 0 is the default.",
      .what_to_do = "Write the range, or remove the attribute that says it is limited.",
      .checks = {on_mjcf({read::MjcfFactKind::kLimitedWithoutRange}, check)},
  };
}

}  // namespace rigor::rules::mjcf_limited_without_range
