// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string_view>

#include <rigor/rules/kinematics/unknown_type.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::joint_type_unknown {
namespace {

void check(const read::SchemaFact& fact, Context& context) {
  if (!is_type_of(fact, "joint")) return;
  // libsdformat does not mind the case of letters, urdfdom does.
  const auto same = [&fact](std::string_view type) {
    return schema::edit_distance(fact.text, type, 0) == 0;
  };
  const auto types = types_of(fact);
  if (context.is_sdf() && std::any_of(types.begin(), types.end(), same)) return;
  report_unknown_type(fact, context);
}

void check_empty(const model::Joint& joint, Context& context) {
  report_empty_type(context.element(joint.site), context.subject(joint), context);
}

}  // namespace

Rule rule() {
  return {
      .name = "joint-type-unknown",
      .category = Category::kKinematics,
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .fix = FixGrade::kUnsafe,
      .summary = "a joint has a type that does not exist",
      .why = "libsdformat and urdfdom refuse the model.",
      .what_to_do =
          "SDF knows revolute, continuous, prismatic, fixed, ball, screw, universal, "
          "revolute2 and gearbox; URDF revolute, continuous, prismatic, fixed, floating "
          "and planar.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="tip"/>
    <joint name="elbow" type="«hinge»">
      <parent>base</parent>
      <child>tip</child>
    </joint>
  </model>
</sdf>
)"},
              {R"(<robot name="arm">
  <link name="base"/>
  <link name="tip"/>
  <joint name="elbow" «type=""»>
    <parent link="base"/>
    <child link="tip"/>
  </joint>
</robot>
)"},
              {R"(<robot name="arm">
  <link name="base"/>
  <link name="tip"/>
  <joint name="elbow" type="«spherical»">
    <parent link="base"/>
    <child link="tip"/>
  </joint>
</robot>
)"},
              {R"(<robot name="arm">
  <link name="base"/>
  <link name="tip"/>
  <joint name="elbow" type="«prismtic»">
    <parent link="base"/>
    <child link="tip"/>
    <limit lower="-1" upper="1" effort="5" velocity="2"/>
  </joint>
</robot>
)",
               R"(<robot name="arm">
  <link name="base"/>
  <link name="tip"/>
  <joint name="elbow" type="prismatic">
    <parent link="base"/>
    <child link="tip"/>
    <limit lower="-1" upper="1" effort="5" velocity="2"/>
  </joint>
</robot>
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
)"},
               {R"(<robot name="arm">
  <link name="base"/>
  <link name="tip"/>
  <joint name="elbow" type="fixed">
    <parent link="base"/>
    <child link="tip"/>
  </joint>
</robot>
)"}},
      .checks = {on_schema({read::SchemaFactKind::kNotInEnumeration}, check),
                 on<model::Joint>(check_empty)},
  };
}

}  // namespace rigor::rules::joint_type_unknown
