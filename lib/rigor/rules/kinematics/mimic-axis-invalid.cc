// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mimic_axis_invalid {
namespace {

void check(const model::Joint& joint, Context& context) {
  for (const model::Axis& axis : joint.axes) {
    if (!axis.mimic) continue;
    const model::Field<std::string>& name = axis.mimic->axis;
    const Span where = name.written ? name.span : axis.mimic->joint.span;
    if (name.value != "axis" && name.value != "axis2") {
      context.report({.where = where,
                      .message = "'" + name.value + "' is no axis that a mimic can follow",
                      .subject = context.subject(joint),
                      .help = "it is one of axis, axis2"});
      continue;
    }
    const auto leader = leader_of(context.frames(), joint, *axis.mimic);
    if (!leader || leading_axis(*axis.mimic) < context.root()[leader].axes.size()) continue;
    context.report({.where = where,
                    .message = "mimics <" + name.value + "> of the joint '" +
                               axis.mimic->joint.value + "', which has none",
                    .subject = context.subject(joint)});
  }
}

}  // namespace

Rule rule() {
  return {
      .name = "mimic-axis-invalid",
      .category = Category::kKinematics,
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .summary = "a mimic follows an axis that its leader does not have",
      .why = "libsdformat 14 and later refuse the file; libsdformat 12 passes over every <mimic>.",
      .what_to_do =
          "Name an axis that is written in the leading joint: axis, or axis2 of one with two.",
      .bad = {{R"(<sdf version="1.11">
  <model name="arm">
    <link name="base"/>
    <link name="tip"/>
    <link name="finger"/>
    <joint name="knuckle" type="revolute">
      <parent>base</parent>
      <child>finger</child>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <lower>-1</lower>
          <upper>1</upper>
        </limit>
      </axis>
    </joint>
    <joint name="elbow" type="revolute">
      <parent>base</parent>
      <child>tip</child>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <lower>-1</lower>
          <upper>1</upper>
        </limit>
        <mimic joint="knuckle" axis="«axis2»">
          <multiplier>1</multiplier>
          <offset>0</offset>
          <reference>0</reference>
        </mimic>
      </axis>
    </joint>
  </model>
</sdf>
)"},
              {R"(<sdf version="1.11">
  <model name="arm">
    <link name="base"/>
    <link name="tip"/>
    <link name="finger"/>
    <joint name="knuckle" type="revolute">
      <parent>base</parent>
      <child>finger</child>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <lower>-1</lower>
          <upper>1</upper>
        </limit>
      </axis>
    </joint>
    <joint name="elbow" type="revolute">
      <parent>base</parent>
      <child>tip</child>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <lower>-1</lower>
          <upper>1</upper>
        </limit>
        <mimic joint="knuckle" axis="«axis3»">
          <multiplier>1</multiplier>
          <offset>0</offset>
          <reference>0</reference>
        </mimic>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.11">
  <model name="arm">
    <link name="base"/>
    <link name="tip"/>
    <link name="finger"/>
    <joint name="knuckle" type="revolute">
      <parent>base</parent>
      <child>finger</child>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <lower>-1</lower>
          <upper>1</upper>
        </limit>
      </axis>
    </joint>
    <joint name="elbow" type="revolute">
      <parent>base</parent>
      <child>tip</child>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <lower>-1</lower>
          <upper>1</upper>
        </limit>
        <mimic joint="knuckle">
          <multiplier>1</multiplier>
          <offset>0</offset>
          <reference>0</reference>
        </mimic>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::mimic_axis_invalid
