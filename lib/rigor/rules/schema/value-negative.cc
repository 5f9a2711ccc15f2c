// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_negative {

void check(const read::SchemaFact& fact, Context& context) {
  const std::string_view element = fact.element.name();
  if (element != "limit" && element != "dynamics")
    return;  // masses and sizes have rules of their own
  const std::string unit(fact.node->unit());
  context.report({.where = fact.where,
                  .message = owner_of(fact) + " is " + quoted_fault(fact) +
                             ": it has to be at least " +
                             std::string(fact.node->minimum().value_or("0")) +
                             (unit.empty() ? "" : " " + unit),
                  .subject = subject_of(fact.element)});
}

Rule rule() {
  return {
      .name = "value-negative",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a number of a URDF joint is negative that cannot be",
      .why = "A simulator reads a negative effort or velocity limit as none, as zero, or rejects "
             "it; negative damping pushes the joint ever faster. urdfdom accepts it.",
      .what_to_do = "Write a number of at least 0.",
      .checks = {on_schema({read::SchemaFactKind::kOutOfRange}, check)},
  };
}

}  // namespace rigor::rules::value_negative
