// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_bad_color {

using FaultKind = schema::ValueFault::Kind;

void check(const read::SchemaFact& fact, Context& context) {
  if (!has_kind(fact, FaultKind::kBadColor)) return;
  context.report(
      {.where = fact.where,
       .message = owner_of(fact) + " has the part " + quoted_fault(fact) + ": each is from 0 to 1",
       .subject = subject_of(fact.element)});
}

Rule rule() {
  return {
      .name = "value-bad-color",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "a colour has a part below 0 or above 1",
      .why = "libsdformat refuses the file; urdfdom drops the material. Parts from 0 to 255 are "
             "written so in other formats.",
      .what_to_do = "Divide the parts by 255.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_bad_color
