// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/dialects.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::consumer_specific_name {

void check(const read::SchemaFact& fact, Context& context) {
  const auto reader = dialect_reader(fact, context);
  if (!reader) return;
  const std::string what = fact.attribute ? "'" + std::string(fact.attribute->name()) + "' of <" +
                                                std::string(fact.element.name()) + ">"
                                          : "<" + std::string(fact.element.name()) + ">";
  context.report({.where = fact.where,
                  .message = "only " + std::string(*reader) + " reads " + what +
                             ": it has no effect elsewhere",
                  .subject = subject_of(fact.element)});
}

Rule rule() {
  return {
      .name = "consumer-specific-name",
      .severity = Severity::kInfo,
      .summary = "an element or attribute that only one consumer reads",
      .why = "The format does not have it, and most readers ignore it: contact constants of "
             "Bullet, frames of Drake, dont_collapse of Isaac Sim. A robot that depends on it "
             "behaves differently in other simulators.",
      .what_to_do = "Nothing, where the model is meant for that consumer. Else express the same in "
                    "the format's own elements, or suppress the rule.",
      .checks = {on_schema(
          {read::SchemaFactKind::kUnknownElement, read::SchemaFactKind::kUnknownAttribute}, check)},
  };
}

}  // namespace rigor::rules::consumer_specific_name
