// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_missing_components {

using FaultKind = schema::ValueFault::Kind;

void check(const read::SchemaFact& fact, Context& context) {
  if (!has_kind(fact, FaultKind::kTooFew) || left_for_xacro(fact)) return;
  context.report({.where = fact.where,
                  .message = owner_of(fact) + " takes " + std::string(expected(fact, context)) +
                             ", not " + quoted_fault(fact),
                  .subject = subject_of(fact.element),
                  .refused = refuses_value(fact, context)});
}

Rule rule() {
  return {
      .name = "value-missing-components",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .summary = "a vector, pose or colour has too few numbers",
      .why = "libsdformat refuses the file. urdfdom refuses the robot, or stops reading the link: "
             "this part and all that follow are not there. A colour of less than four numbers it "
             "takes for black.",
      .what_to_do = "Write all the numbers, with spaces between them.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_missing_components
