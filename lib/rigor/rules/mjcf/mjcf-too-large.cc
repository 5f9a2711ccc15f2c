// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_too_large {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = fact.detail + ": the file is not read to its end",
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-too-large",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "copies and attached models bring more than rigor holds",
      .why = "No robot needs 200,000 parts; a simulator will run out of memory or time. "
             "What lies beyond is not checked, so that the model is neither converted nor "
             "compared.",
      .what_to_do = "Look for a <replicate> or <attach> that multiplies itself, and write the "
                    "count that is meant.",
      .checks = {on_mjcf({read::MjcfFactKind::kTooLarge}, check)},
  };
}

}  // namespace rigor::rules::mjcf_too_large
