// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::deprecated_element {

/// What to do about it: the concise report has the message alone.
std::string instead_of(const read::SchemaFact& fact) {
  const schema::Node& node = *fact.node;
  const std::string above(fact.ancestor(2));
  if (node.instead() == node.name() && !above.empty()) return ": write it in <" + above + ">";
  if (!node.instead().empty()) return ": write '" + std::string(node.instead()) + "'";
  return node.doc().starts_with("Without effect") ? ": it has no effect" : "";
}

void check(const read::SchemaFact& fact, Context& context) {
  const auto since = fact.node->deprecated_since();
  std::string message = "'" + std::string(fact.node->name()) + "' is deprecated";
  if (context.is_sdf() && since) message += " since SDF " + schema::to_string(*since);
  context.report({.where = fact.where,
                  .message = message + instead_of(fact),
                  .subject = subject_of(fact.element)});
}

Rule rule() {
  return {
      .name = "deprecated-element",
      .severity = Severity::kInfo,
      .summary = "an element or attribute is deprecated in this version",
      .why = "It still has its effect, and will lose it in a later version of the format.",
      .what_to_do = "Write what the message names in its place.",
      .checks = {on_schema({read::SchemaFactKind::kDeprecated}, check)},
  };
}

}  // namespace rigor::rules::deprecated_element
