// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::missing_attribute {
namespace {

/// What stands there in its place: another spelling, or a child element.
std::string instead(const read::SchemaFact& fact, std::string_view name) {
  for (const xml::Attribute attribute : fact.element.attributes()) {
    if (fact.parent->attribute(attribute.name())) continue;
    if (schema::near(attribute.name(), {name}).empty()) continue;
    return "did you mean '" + std::string(name) + "' by '" + std::string(attribute.name()) + "'?";
  }
  if (!fact.element.child(name)) return {};
  return "<" + std::string(name) + "> is written as a child: it is an attribute";
}

/// It takes the default where there is one, passes over a colour or texture without a value, and
/// reads no sensors.
bool urdfdom_minds_not(const read::SchemaFact& fact) {
  const std::string_view element = fact.element.name();
  return fact.node->default_value() || element == "color" || element == "texture" ||
         element == "sensor";
}

void check(const read::SchemaFact& fact, Context& context) {
  const std::string_view element = fact.element.name();
  const std::string_view name = fact.node->name();
  const bool root = element == "sdf" || element == "gazebo";
  if (root && name == "version") return;  // sdf-version-missing
  if (context.is_urdf() && urdfdom_minds_not(fact)) return;
  context.report({.where = fact.where,
                  .message = "<" + std::string(element) + "> has no '" + std::string(name) + "'",
                  .subject = subject_of(fact.element),
                  .help = instead(fact, name)});
}

}  // namespace

Rule rule() {
  return {
      .name = "missing-attribute",
      .category = Category::kSchema,
      .severity = Severity::kError,
      .summary = "a required attribute is missing",
      .why =
          "libsdformat refuses the file at this element. urdfdom refuses the robot, or leaves the "
          "link without the part.",
      .what_to_do = "Add the attribute.",
      .bad = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    «<link nmae="body">»
    </link>
  </model>
</sdf>
)"},
              {R"(<robot name="box">
  <link name="body">
    <collision>
      <geometry>«<sphere/>»</geometry>
    </collision>
  </link>
</robot>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)"},
               {R"(<robot name="box">
  <link name="body">
    <collision>
      <geometry><sphere radius="1"/></geometry>
    </collision>
  </link>
</robot>
)"}},
      .checks = {on_schema({read::SchemaFactKind::kMissingAttribute}, check)},
  };
}

}  // namespace rigor::rules::missing_attribute
