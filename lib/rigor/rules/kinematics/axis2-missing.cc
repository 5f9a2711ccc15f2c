// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>

namespace rigor::rules::axis2_missing {
namespace {

void check(const model::Joint& joint, Context& context) {
  if (degrees_of_freedom(joint.type) != 2 || joint.axes.size() != 1) return;
  const xml::Element element = context.element(joint.site);
  if (element.child("axis2") || has_xacro_child(element)) return;
  context.report({.where = joint.type_name.span,
                  .message = "a " + std::string(to_string(joint.type)) +
                             " joint has two axes, and this one has no <axis2>",
                  .subject = context.subject(joint)});
}

}  // namespace

Rule rule() {
  return {
      .name = "axis2-missing",
      .category = Category::kKinematics,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a joint with two axes has only one",
      .why =
          "The second axis is z of the joint's frame then, as SDF defaults an axis, or is "
          "not there at all: the joint turns another way than was meant, or about one axis "
          "only.",
      .what_to_do = "Write <axis2>, or make the joint revolute.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="tip"/>
    <joint name="elbow" type="«universal»">
      <parent>base</parent>
      <child>tip</child>
      <axis>
        <xyz>0 0 1</xyz>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="tip"/>
    <joint name="elbow" type="universal">
      <parent>base</parent>
      <child>tip</child>
      <axis>
        <xyz>0 0 1</xyz>
      </axis>
      <axis2>
        <xyz>0 1 0</xyz>
      </axis2>
    </joint>
  </model>
</sdf>
)"},
               {R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="tip"/>
    <joint name="elbow" type="revolute">
      <parent>base</parent>
      <child>tip</child>
      <axis>
        <xyz>0 0 1</xyz>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::axis2_missing
