// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/value_in_attribute.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_empty {

using FaultKind = schema::ValueFault::Kind;

bool holds_its_value(const read::SchemaFact& fact) {
  for (const xml::Attribute attribute : fact.element.attributes()) {
    if (holds_value(attribute, fact.element, *fact.node)) return true;
  }
  return false;
}

bool is_mass_of_link(const read::SchemaFact& fact) {
  return fact.element.name() == "mass" && fact.ancestor(1) == "inertial";
}

void check(const read::SchemaFact& fact, Context& context) {
  if (!has_kind(fact, FaultKind::kEmpty)) return;
  if (fact.node->cardinality() == schema::Cardinality::kOne) return;  // value-malformed
  if (fact.node->type() == schema::Type::kPose)
    return;  // <pose relative_to="a"/> is how it is done
  if (!fact.attribute && holds_its_value(fact)) return;  // unknown-attribute
  if (is_mass_of_link(fact)) return;                     // mass-not-written
  const auto value = fact.node->default_value();
  std::string message = owner_of(fact) + " is empty";
  if (value && !value->empty()) message += ": it is " + std::string(*value);
  // An attribute may be read even where the value is not.
  std::optional<Fix> fix;
  if (!fact.attribute && fact.element.attributes().empty() && fact.element.children().empty()) {
    fix = fix_of("remove it", Applicability::kSafe,
                 xml::remove_element(context.document(), fact.element));
  }
  context.report({.where = fact.where.size() > 0 ? fact.where : fact.element.name_span(),
                  .message = std::move(message),
                  .subject = subject_of(fact.element),
                  .fix = std::move(fix)});
}

Rule rule() {
  return {
      .name = "value-empty",
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .fix = FixGrade::kSafe,
      .summary = "a value is empty, and its default counts",
      .why = "libsdformat takes the default, as if the element were not there.",
      .what_to_do = "Write the value, or remove the element.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_empty
