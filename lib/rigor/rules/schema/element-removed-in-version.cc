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

void check(const read::SchemaFact& fact, Context& context) {
  if (written_as_attribute(fact)) return;
  std::optional<Fix> fix;
  if (fact.attribute && holds_value(*fact.attribute, fact.element, *fact.parent)) {
    if (is_end_of_joint(fact)) return;  // missing-element
    fix = value_as_text(*fact.attribute, fact.element, context);
  }
  const std::string format = context.is_urdf() ? "URDF " : "SDF ";
  const auto until = fact.node->until();
  context.report(
      {.where = fact.where,
       .message = "'" + std::string(context.bytes(fact.where)) + "' has no effect in " + format +
                  schema::to_string(fact.parent->version()) +
                  (until ? ": it was last in " + schema::to_string(*until) : ""),
       .subject = subject_of(fact.element),
       .help = fact.node->instead().empty() ? "" : "write " + std::string(fact.node->instead()),
       .fix = std::move(fix)});
}

Rule rule() {
  return {
      .name = "element-removed-in-version",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "an element or attribute is no longer in the version of the file",
      .why = "libsdformat passes over it without a word: what it says has no effect. Often the "
             "version was raised and the rest of the file was not.",
      .what_to_do = "Write what the version has in its place, or lower the version of the file.",
      .checks = {on_schema({read::SchemaFactKind::kRemovedInVersion}, check)},
  };
}

}  // namespace rigor::rules::element_removed_in_version
