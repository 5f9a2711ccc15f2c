// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/values.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::attribute_as_element {

std::optional<Fix> as_attribute(const read::SchemaFact& fact, const Context& context) {
  const auto& element = fact.element;
  const auto parent = element.parent();
  const std::string_view value = read::trimmed(element.text());
  const bool plain = element.attributes().empty() && element.children().empty();
  if (!parent || !plain || value.empty() || parent->attribute(element.name())) return std::nullopt;
  std::vector<Edit> edits = xml::remove_element(context.document(), element);
  append(edits, xml::set_attribute(context.document(), *parent, element.name(), value));
  return fix_of("write it as an attribute", Applicability::kUnsafe, std::move(edits));
}

/// Whether a required attribute of the parent is written as an element, too: missing-attribute says it of all.
bool is_form_of_parent(const read::SchemaFact& fact) {
  const auto parent = fact.element.parent();
  if (!parent) return false;
  for (const schema::Node required : fact.parent->required_attributes()) {
    if (!parent->attribute(required.name()) && parent->child(required.name())) return true;
  }
  return false;
}

void check(const read::SchemaFact& fact, Context& context) {
  const std::string name(fact.element.name());
  if (is_form_of_parent(fact)) return;
  context.report({.where = fact.where,
                  .message = "<" + name + "> has no effect: '" + name + "' is an attribute of <" +
                             std::string(fact.parent->name()) + ">",
                  .subject = subject_of(fact.element),
                  .fix = as_attribute(fact, context)});
}

Rule rule() {
  return {
      .name = "attribute-as-element",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "an attribute is written as an element",
      .why = "libsdformat, urdfdom and Gazebo look for an attribute and ignore the element "
             "silently: it has no effect.",
      .what_to_do = "Write it into the start tag.",
      .checks = {on_schema({read::SchemaFactKind::kAttributeAsElement}, check)},
  };
}

}  // namespace rigor::rules::attribute_as_element
