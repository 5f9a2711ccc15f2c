// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_value_rejected {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where, .message = fact.name + " " + fact.detail, .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-value-rejected",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "value that MuJoCo rejects",
      .why = "MuJoCo rejects the file: it compiles no such value.",
      .what_to_do = "Write a value that the message allows, or remove the attribute.",
      .checks = {on_mjcf({read::MjcfFactKind::kValueRejected}, check)},
  };
}

}  // namespace rigor::rules::mjcf_value_rejected
