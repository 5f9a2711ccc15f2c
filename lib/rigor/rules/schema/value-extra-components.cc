// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_extra_components {

using FaultKind = schema::ValueFault::Kind;

void check(const read::SchemaFact& fact, Context& context) {
  const schema::Type type = fact.node->type();
  if (!has_kind(fact, FaultKind::kTooMany) || left_for_xacro(fact)) return;
  if (type == schema::Type::kPose || type == schema::Type::kColor) return;  // value-malformed
  context.report({.where = fact.where,
                  .message = owner_of(fact) + " takes " + std::string(expected(type)) + ": " +
                             quoted_fault(fact) + " is passed over",
                  .subject = subject_of(fact.element),
                  .fix = Fix{"remove what is too much",
                             Applicability::kUnsafe,
                             {without_part(context, fact.where)}}});
}

Rule rule() {
  return {
      .name = "value-extra-components",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a vector has more numbers than it takes",
      .why = "libsdformat reads the first ones and passes over the rest without a word.",
      .what_to_do = "Remove what is too much, or look whether another element was meant.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_extra_components
