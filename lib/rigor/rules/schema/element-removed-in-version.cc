// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <utility>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/rules/schema/value_in_attribute.h>

namespace rigor::rules::element_removed_in_version {

bool is_end_of_joint(const read::SchemaFact& fact) {
  const std::string_view name = fact.element.name();
  return fact.ancestor(1) == "joint" && (name == "parent" || name == "child");
}

/// `frame=""` and `<velocity_decay/>` hold nothing that could be lost.
bool is_empty(const read::SchemaFact& fact) {
  if (fact.attribute) return read::trimmed(fact.attribute->value()).empty();
  return fact.element.children().empty() && fact.element.attributes().empty() &&
         read::trimmed(fact.element.text()).empty();
}

std::string help_of(const read::SchemaFact& fact) {
  if (is_empty(fact)) return "remove it: it holds nothing";
  return fact.node->instead().empty() ? "" : "write " + std::string(fact.node->instead());
}

void check(const read::SchemaFact& fact, Context& context) {
  if (written_as_attribute(fact)) return;
  std::optional<Fix> fix;
  if (fact.attribute && holds_value(*fact.attribute, fact.element, *fact.parent)) {
    if (is_end_of_joint(fact)) return;  // missing-element
    fix = value_as_text(*fact.attribute, fact.element, context);
  }
  const std::string format = context.is_urdf() ? "URDF " : "SDF ";
  const auto until = fact.node->until();
  context.report({.where = fact.where,
                  .message = "'" + std::string(context.bytes(fact.where)) + "' has no effect in " +
                             format + schema::to_string(fact.parent->version()) +
                             (until ? ": it was last in " + schema::to_string(*until) : ""),
                  .subject = subject_of(fact.element),
                  .help = help_of(fact),
                  .fix = std::move(fix),
                  .severity = is_empty(fact) ? std::optional(Severity::kInfo) : std::nullopt});
}

Rule rule() {
  return {
      .name = "element-removed-in-version",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "an element or attribute is no longer in the version of the file",
      .why = "libsdformat ignores it silently. Often the version was raised and the rest of the "
             "file was not. Where it is empty, nothing is lost, which is an info.",
      .what_to_do = "Write what the version has in its place, or lower the version of the file.",
      .checks = {on_schema({read::SchemaFactKind::kRemovedInVersion}, check)},
  };
}

}  // namespace rigor::rules::element_removed_in_version
