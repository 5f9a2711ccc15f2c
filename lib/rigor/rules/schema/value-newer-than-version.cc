// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/enumeration.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_newer_than_version {

/// The latest version that libsdformat 12 knows: it refuses values that came later.
constexpr schema::Version kLatestOfSdformat12{9};

void check(const read::SchemaFact& fact, Context& context) {
  const auto since = listed_since(fact);
  if (!since) return;
  const std::string format = context.is_urdf() ? "URDF " : "SDF ";
  context.report({.where = fact.where,
                  .message = quoted_fault(fact) + " is a value of " + owner_of(fact) + " since " +
                             format + schema::to_string(*since) + ": this file is " + format +
                             schema::to_string(fact.node->version()),
                  .subject = subject_of(fact.element),
                  .refused = context.is_sdf() && *since > kLatestOfSdformat12 &&
                             keeper_of(fact) != ListKeeper::kUnchecked});
}

Rule rule() {
  return {
      .name = "value-newer-than-version",
      .severity = Severity::kWarning,
      .refused = {.sdf = Refusal::kSays},
      .summary = "a value is newer than the version of the file",
      .why = "libsdformat compares values with the newest version that it knows, whatever the "
             "version of the file: a release from before the value rejects the file, a later one "
             "accepts it.",
      .what_to_do = "Raise the version of the file to the one that has the value; where an older "
                    "reader has to load it, use a value of the older version.",
      .checks = {on_schema({read::SchemaFactKind::kNotInEnumeration}, check)},
  };
}

}  // namespace rigor::rules::value_newer_than_version
