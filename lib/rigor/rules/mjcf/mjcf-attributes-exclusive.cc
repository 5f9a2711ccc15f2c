// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_attributes_exclusive {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = fact.name + " and " + fact.detail + " are both written",
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-attributes-exclusive",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "attributes that exclude each other",
      .why = "MuJoCo rejects the file: of the two attributes only one may be written.",
      .what_to_do = "Keep one of them.",
      .checks = {on_mjcf({read::MjcfFactKind::kExcludes}, check)},
  };
}

}  // namespace rigor::rules::mjcf_attributes_exclusive
