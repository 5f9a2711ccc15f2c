// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::element_as_attribute {

/// Those of an element that are children of it, of which the first speaks for all.
std::vector<xml::Attribute> children_of(xml::Element element, const schema::Node& node) {
  std::vector<xml::Attribute> found;
  for (const xml::Attribute attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (!node.attribute(name) && node.child(name)) found.push_back(attribute);
  }
  return found;
}

/// All in one go: of a half of a tensor no rule could say anything right.
std::optional<Fix> as_elements(const std::vector<xml::Attribute>& attributes, xml::Element element,
                               const Context& context) {
  std::vector<Edit> edits;
  std::string children;
  for (const xml::Attribute attribute : attributes) {
    const std::string name(attribute.name());
    if (element.child(name)) continue;
    append(edits, xml::remove_attribute(context.document(), attribute));
    children += (children.empty() ? "<" : "\n<") + name + ">" + xml::escaped(attribute.value()) +
                "</" + name + ">";
  }
  if (edits.empty()) return std::nullopt;
  append(edits, xml::insert_child(context.document(), element, std::nullopt, children));
  return fix_of(attributes.size() == 1 ? "write it as a child" : "write them as children",
                Applicability::kUnsafe, std::move(edits));
}

std::string message(const std::vector<xml::Attribute>& attributes, xml::Element element) {
  const std::string parent = "<" + std::string(element.name()) + ">";
  if (attributes.size() == 1) {
    const std::string name(attributes.front().name());
    return "the attribute '" + name + "' has no effect: <" + name + "> is a child of " + parent;
  }
  std::string names;
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    names += i == 0 ? "'" : i + 1 < attributes.size() ? ", '" : " and '";
    names += std::string(attributes[i].name()) + "'";
  }
  return "the attributes " + names + " have no effect: they are children of " + parent;
}

void check(const read::SchemaFact& fact, Context& context) {
  if (!written_as_attribute(fact)) return;
  const auto attributes = children_of(fact.element, *fact.parent);
  if (attributes.front().name() != fact.attribute->name()) return;
  context.report({.where = fact.where,
                  .message = message(attributes, fact.element),
                  .subject = subject_of(fact.element),
                  .fix = as_elements(attributes, fact.element, context)});
}

Rule rule() {
  return {
      .name = "element-as-attribute",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "an element is written as an attribute",
      .why = "libsdformat, urdfdom and Gazebo look for an element of that name and pass over the "
             "attribute: what it says has no effect, and the default counts. SDF has most values "
             "as elements, URDF as attributes.",
      .what_to_do = "Write it as a child element.",
      .checks = {on_schema(
          {read::SchemaFactKind::kElementAsAttribute, read::SchemaFactKind::kRemovedInVersion},
          check)},
  };
}

}  // namespace rigor::rules::element_as_attribute
