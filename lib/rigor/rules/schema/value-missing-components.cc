// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_missing_components {

using FaultKind = schema::ValueFault::Kind;

void check(const read::SchemaFact& fact, Context& context) {
  if (!has_kind(fact, FaultKind::kTooFew) || left_for_xacro(fact)) return;
  const bool is_urdf_color = context.is_urdf() && fact.node->type() == schema::Type::kColor;
  context.report({.where = fact.where,
                  .message = owner_of(fact) + " takes " + std::string(expected(fact, context)) +
                             ", not " + quoted_fault(fact),
                  .subject = subject_of(fact.element),
                  .refused = refuses_value(fact, context),
                  .why = is_urdf_color ? "urdfdom takes the color for black, with an error." : "",
                  .severity = is_urdf_color ? std::optional(Severity::kWarning) : std::nullopt});
}

Rule rule() {
  return {
      .name = "value-missing-components",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .summary = "a vector, pose or color has too few numbers",
      .why = "libsdformat rejects the file. urdfdom rejects the robot, or stops reading the link: "
             "this part and all that follow are not there. A color of less than four numbers it "
             "takes for black, which is a warning.",
      .what_to_do = "Write all the numbers, with spaces between them.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_missing_components
