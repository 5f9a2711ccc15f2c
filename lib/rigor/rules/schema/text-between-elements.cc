// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/rules/xml/xacro.h>

namespace rigor::rules::text_between_elements {
namespace {

/// `<mass>3</mass>` in URDF: missing-attribute says what is wrong.
bool meant_as_attribute(const read::SchemaFact& fact, const Context& context) {
  if (!context.is_urdf() || !fact.element.children().empty()) return false;
  for (const schema::Node required : fact.node->required_attributes()) {
    if (!fact.element.attribute(required.name())) return true;
  }
  return false;
}

void check(const read::SchemaFact& fact, Context& context) {
  if (meant_as_attribute(fact, context) || has_xacro(context.bytes(fact.where))) return;
  if (fact.element.name() == "script") return;  // material-script-incomplete
  context.report(
      {.where = fact.where,
       .message = "text in <" + std::string(fact.element.name()) + "> that has no effect",
       .subject = subject_of(fact.element),
       .fix = Fix{"remove it", Applicability::kUnsafe, {without(context, fact.where)}}});
}

}  // namespace

Rule rule() {
  return {
      .name = "text-between-elements",
      .category = Category::kSchema,
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "characters stand where nobody reads them",
      .why =
          "libsdformat, urdfdom and Gazebo take the first run of text of an element that has a "
          "value, and no text of one that has none: the rest has no effect. A comment inside a "
          "number splits it, and the first part counts.",
      .what_to_do = "Remove the characters, or make them a comment.",
      .bad = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body">«the box itself»</link>
  </model>
</sdf>
)",
               R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"></link>
  </model>
</sdf>
)"},
              {R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body">
      <collision name="shape">
        <geometry><sphere><radius>5<!-- or -->«6»</radius></sphere></geometry>
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
        <geometry><sphere><radius>5<!-- or --></radius></sphere></geometry>
      </collision>
    </link>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"><!-- the box itself --></link>
  </model>
</sdf>
)"}},
      .checks = {on_schema({read::SchemaFactKind::kLostText}, check)},
  };
}

}  // namespace rigor::rules::text_between_elements
