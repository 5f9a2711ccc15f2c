// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_include_repeated {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where, .message = "'" + fact.name + "' is included twice"});
}

Rule rule() {
  return {
      .name = "mjcf-include-repeated",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "file is included twice",
      .why = "MuJoCo rejects the file: each file can be included once.",
      .what_to_do = "Remove one of the includes.",
      .checks = {on_mjcf({read::MjcfFactKind::kIncludeRepeated}, check)},
  };
}

}  // namespace rigor::rules::mjcf_include_repeated
