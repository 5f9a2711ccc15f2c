// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>

namespace rigor::rules::axis_missing {
namespace {

void check(const model::Joint& joint, Context& context) {
  if (!has_axis(joint.type) || !joint.axes.empty()) return;
  if (has_xacro_child(context.element(joint.site))) return;
  context.report({.where = joint.site.name,
                  .message = "the " + std::string(to_string(joint.type)) +
                             " joint has no <axis>: it is taken to move along z (0 0 1)",
                  .subject = context.subject(joint)});
}

}  // namespace

Rule rule() {
  return {
      .name = "axis-missing",
      .category = Category::kKinematics,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a joint that moves along an axis has none",
      .why =
          "SDF then takes the z axis of the joint's frame. URDF takes x, so the robot changes "
          "when it is converted by hand.",
      .what_to_do = "Write the axis: <axis><xyz>0 0 1</xyz></axis>.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="tip"/>
    <«joint» name="elbow" type="revolute">
      <parent>base</parent>
      <child>tip</child>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
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

}  // namespace rigor::rules::axis_missing
