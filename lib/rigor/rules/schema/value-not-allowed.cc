// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/enumeration.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_not_allowed {

void check(const read::SchemaFact& fact, Context& context) {
  if (keeper_of(fact) != ListKeeper::kRefuses || left_for_xacro(fact) || listed_since(fact)) return;
  report_unlisted(fact, context);
}

Rule rule() {
  return {
      .name = "value-not-allowed",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .fix = FixGrade::kUnsafe,
      .summary = "a value is none of those that its place takes",
      .why =
          "libsdformat refuses the file. Here the case of letters counts too: Point is not point.",
      .what_to_do = "Write one of the values that the message names.",
      .checks = {on_schema({read::SchemaFactKind::kNotInEnumeration}, check)},
  };
}

}  // namespace rigor::rules::value_not_allowed
