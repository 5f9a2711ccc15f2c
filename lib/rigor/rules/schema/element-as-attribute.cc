// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::element_as_attribute {
namespace {

std::optional<Fix> as_element(const read::SchemaFact& fact, const Context& context) {
  const std::string name(fact.attribute->name());
  if (fact.element.child(name)) return std::nullopt;
  const std::string child =
      "<" + name + ">" + xml::escaped(fact.attribute->value()) + "</" + name + ">";
  std::vector<Edit> edits = xml::remove_attribute(context.document(), *fact.attribute);
  append(edits, xml::insert_child(context.document(), fact.element, std::nullopt, child));
  return fix_of("write it as a child", Applicability::kUnsafe, std::move(edits));
}

void check(const read::SchemaFact& fact, Context& context) {
  if (!written_as_attribute(fact)) return;
  const std::string name(fact.attribute->name());
  context.report({.where = fact.where,
                  .message = "the attribute '" + name + "' has no effect: <" + name +
                             "> is a child of <" + std::string(fact.element.name()) + ">",
                  .subject = subject_of(fact.element),
                  .fix = as_element(fact, context)});
}

}  // namespace

Rule rule() {
  return {
      .name = "element-as-attribute",
      .category = Category::kSchema,
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "an element is written as an attribute",
      .why =
          "libsdformat, urdfdom and Gazebo look for an element of that name and pass over the "
          "attribute: what it says has no effect, and the default counts. SDF has most values as "
          "elements, URDF as attributes.",
      .what_to_do = "Write it as a child element.",
      .bad = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body">
      <collision name="shape">
        <geometry><sphere «radius»="0.2"/></geometry>
      </collision>
    </link>
  </model>
</sdf>
)",
               R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body">
      <collision name="shape">
        <geometry><sphere><radius>0.2</radius></sphere></geometry>
      </collision>
    </link>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body">
      <collision name="shape">
        <geometry><sphere><radius>0.2</radius></sphere></geometry>
      </collision>
    </link>
  </model>
</sdf>
)"}},
      .checks = {on_schema(
          {read::SchemaFactKind::kElementAsAttribute, read::SchemaFactKind::kRemovedInVersion},
          check)},
  };
}

}  // namespace rigor::rules::element_as_attribute
