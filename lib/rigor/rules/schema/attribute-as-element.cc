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

void check(const read::SchemaFact& fact, Context& context) {
  const std::string name(fact.element.name());
  const auto parent = fact.element.parent();
  const bool required = fact.node->cardinality() == schema::Cardinality::kOne;
  if (required && parent && !parent->attribute(name)) return;  // missing-attribute
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
      .why = "libsdformat, urdfdom and Gazebo look for it in the start tag and pass over the "
             "element without a word: what it says has no effect.",
      .what_to_do = "Write it into the start tag.",
      .checks = {on_schema({read::SchemaFactKind::kAttributeAsElement}, check)},
  };
}

}  // namespace rigor::rules::attribute_as_element
