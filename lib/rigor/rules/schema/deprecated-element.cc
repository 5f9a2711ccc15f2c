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

/// What readers have ceased to read changes the robot; the schema says "Ignored" of it.
std::optional<Severity> severity_of(const read::SchemaFact& fact) {
  if (fact.node->doc().starts_with("Ignored")) return Severity::kWarning;
  return std::nullopt;
}

void check(const read::SchemaFact& fact, Context& context) {
  const auto since = fact.node->deprecated_since();
  const bool ignored = fact.node->doc().starts_with("Ignored");
  std::string message =
      "'" + std::string(fact.node->name()) + (ignored ? "' is ignored" : "' is deprecated");
  if (context.is_sdf() && since) message += " since SDF " + schema::to_string(*since);
  context.report({.where = fact.where,
                  .message = message + instead_of(fact),
                  .subject = subject_of(fact.element),
                  .why = ignored ? "No reader of URDF heeds it: its values have no effect." : "",
                  .severity = severity_of(fact)});
}

Rule rule() {
  return {
      .name = "deprecated-element",
      .severity = Severity::kInfo,
      .summary = "an element or attribute is deprecated in this version",
      .why = "It still has its effect, and may lose it in a later version of the format. What "
             "readers ignore already (<joint_properties> of URDF) is a warning.",
      .what_to_do = "Write what the message names in its place.",
      .checks = {on_schema({read::SchemaFactKind::kDeprecated}, check)},
  };
}

}  // namespace rigor::rules::deprecated_element
