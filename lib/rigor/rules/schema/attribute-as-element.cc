// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::attribute_as_element {
namespace {

void check(const read::SchemaFact& fact, Context& context) {
  const std::string name(fact.element.name());
  const auto parent = fact.element.parent();
  const bool required = fact.node->cardinality() == schema::Cardinality::kOne;
  if (required && parent && !parent->attribute(name)) return;  // missing-attribute
  context.report({.where = fact.where,
                  .message = "<" + name + "> has no effect: '" + name + "' is an attribute of <" +
                             std::string(fact.parent->name()) + ">",
                  .subject = subject_of(fact.element)});
}

}  // namespace

Rule rule() {
  return {
      .name = "attribute-as-element",
      .category = Category::kSchema,
      .severity = Severity::kWarning,
      .summary = "an attribute is written as an element",
      .why =
          "libsdformat, urdfdom and Gazebo look for it in the start tag and pass over the element "
          "without a word: what it says has no effect.",
      .what_to_do = "Write it into the start tag.",
      .bad = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
    <frame name="lid">
      <«attached_to»>body</attached_to>
    </frame>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
    <frame name="lid" attached_to="body"/>
  </model>
</sdf>
)"}},
      .checks = {on_schema({read::SchemaFactKind::kAttributeAsElement}, check)},
  };
}

}  // namespace rigor::rules::attribute_as_element
