// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/xml/edit.h>

namespace rigor::rules::wrong_case_element {

/// In the end tag, too. Nothing in a file that ends to be XML somewhere.
std::optional<Fix> rename(const read::SchemaFact& fact, const Context& context) {
  const std::string name(fact.node->name());
  std::vector<Edit> edits{{fact.where, name}};
  if (!fact.attribute) edits = xml::rename_element(context.document(), fact.element, name);
  if (edits.empty()) return std::nullopt;
  return Fix{"write '" + name + "'", Applicability::kUnsafe, std::move(edits)};
}

/// Whether the right name is there already, so that a renamed one would be one too many.
bool stands_beside(const read::SchemaFact& fact) {
  if (fact.attribute) return fact.element.attribute(fact.node->name()).has_value();
  const auto parent = fact.element.parent();
  return parent && parent->child(fact.node->name()) &&
         fact.node->cardinality() != schema::Cardinality::kMany;
}

void check(const read::SchemaFact& fact, Context& context) {
  if (fact.attribute && meant_for_missing(fact, fact.attribute->name())) return;
  Finding finding{.where = fact.where,
                  .message = "'" + std::string(context.bytes(fact.where)) + "' has no effect: '" +
                             std::string(fact.node->name()) + "' is written in other letters",
                  .subject = subject_of(fact.element)};
  if (!stands_beside(fact)) finding.fix = rename(fact, context);
  context.report(std::move(finding));
}

Rule rule() {
  return {
      .name = "wrong-case-element",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a name is written with the wrong upper- and lower-case letters",
      .why = "The names of elements and attributes are told apart by case: <Visual> is passed over "
             "without a word, like any unknown element.",
      .what_to_do = "Write the name as the message has it. The fix makes effective what had no "
                    "effect before, so it is an unsafe one.",
      .checks = {on_schema({read::SchemaFactKind::kWrongCase}, check)},
  };
}

}  // namespace rigor::rules::wrong_case_element
