// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string_view>

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/version.h>

namespace rigor::rules::sdf_version_unknown {

/// libsdformat takes any number, and comes to an end over what is none.
bool no_number(std::string_view version) {
  return !version.empty() && version.find_first_of("0123456789") != 0;
}

void check(const read::Fact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "'" + fact.name + "' is no version of SDF",
                  .help = "the file is checked as SDF " +
                          schema::to_string(schema::Version{context.root().version}),
                  .refused = no_number(fact.name)});
}

Rule rule() {
  return {
      .name = "sdf-version-unknown",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays},
      .formats = Formats::kSdf,
      .summary = "no such version of SDF exists",
      .why = "libsdformat cannot convert the file and reads it as if it were the newest version; "
             "some words make it crash.",
      .what_to_do = "Write a version that exists: 1.0, and 1.2 to 1.12.",
      .checks = {on_read({read::FactKind::kVersionUnknown}, check)},
  };
}

}  // namespace rigor::rules::sdf_version_unknown
