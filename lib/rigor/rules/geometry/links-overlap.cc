// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/geometry/overlapping_links.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::links_overlap {
namespace {

void check(const model::Root& root, Context& context) {
  if (root.links.size() < 2 || root.collisions.size() < 2) return;
  const LinkOverlaps found = lasting_overlaps(root, context.frames());
  if (found.empty()) return;
  const SelfColliding self_colliding(root, context);
  for (const auto& [top, pairs] : found) {
    if (!root.own(root[top].site)) continue;
    std::vector<LinkOverlap> quiet;  // of the others links-collide-at-start speaks
    for (const LinkOverlap& pair : pairs) {
      if (!self_collide(pair, self_colliding)) quiet.push_back(pair);
    }
    report_overlaps(root[top], quiet, "where the model begins", context);
  }
}

}  // namespace

Rule rule() {
  return {
      .name = "links-overlap",
      .category = Category::kGeometry,
      .severity = Severity::kInfo,
      .summary = "links of a model that no joint connects overlap",
      .why =
          "Gazebo does not let the links of a model collide unless <self_collide> says so. MuJoCo "
          "and "
          "Drake do, but for parent and child: there the two push each other from the first step "
          "on. "
          "A motion planner calls the pose a collision. Boxes, balls, cylinders and the like are "
          "looked at, meshes are not; where zero is outside a joint's limits, the joint is taken "
          "at "
          "the nearest limit.",
      .what_to_do =
          "Make the collisions smaller, or move them apart; or exclude the pair where the model is "
          "used: <exclude> in MJCF, <disable_collisions> in SRDF.",
      .bad = {{R"(<sdf version="1.9">
  <«model» name="arm">
    <link name="base">
      <collision name="block">
        <geometry><box><size>0.2 0.2 0.1</size></box></geometry>
      </collision>
    </link>
    <link name="upper">
      <pose>0 0 0.15 0 0 0</pose>
      <collision name="tube">
        <geometry><cylinder><radius>0.03</radius><length>0.2</length></cylinder></geometry>
      </collision>
    </link>
    <link name="hand">
      <pose>0.05 0 0.06 0 0 0</pose>
      <collision name="palm">
        <geometry><box><size>0.1 0.1 0.1</size></box></geometry>
      </collision>
    </link>
    <joint name="shoulder" type="revolute">
      <parent>base</parent>
      <child>upper</child>
      <axis><xyz>0 1 0</xyz></axis>
    </joint>
    <joint name="wrist" type="revolute">
      <parent>upper</parent>
      <child>hand</child>
      <axis><xyz>0 1 0</xyz></axis>
    </joint>
  </model>
</sdf>
)"},
              {R"(<«robot» name="arm">
  <link name="base">
    <collision>
      <geometry><box size="0.2 0.2 0.1"/></geometry>
    </collision>
  </link>
  <link name="left">
    <collision>
      <geometry><sphere radius="0.05"/></geometry>
    </collision>
  </link>
  <link name="right">
    <collision>
      <geometry><sphere radius="0.05"/></geometry>
    </collision>
  </link>
  <joint name="left_hinge" type="continuous">
    <parent link="base"/>
    <child link="left"/>
    <origin xyz="0 0.02 0.1"/>
    <axis xyz="0 1 0"/>
  </joint>
  <joint name="right_hinge" type="continuous">
    <parent link="base"/>
    <child link="right"/>
    <origin xyz="0 -0.02 0.1"/>
    <axis xyz="0 1 0"/>
  </joint>
</robot>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base">
      <collision name="block">
        <geometry><box><size>0.2 0.2 0.1</size></box></geometry>
      </collision>
    </link>
    <link name="fork"/>
    <link name="wheel">
      <collision name="tyre">
        <geometry><sphere><radius>0.1</radius></sphere></geometry>
      </collision>
    </link>
    <joint name="swivel" type="revolute">
      <parent>base</parent>
      <child>fork</child>
      <axis><xyz>0 0 1</xyz></axis>
    </joint>
    <joint name="axle" type="revolute">
      <parent>fork</parent>
      <child>wheel</child>
      <axis><xyz>0 1 0</xyz></axis>
    </joint>
  </model>
</sdf>
)"},
               // At zero the finger is in the base, but its joint never is at zero.
               {R"(<robot name="gripper">
  <link name="base">
    <collision>
      <geometry><box size="0.1 0.1 0.1"/></geometry>
    </collision>
  </link>
  <link name="slide">
    <collision>
      <origin xyz="0 0 0.1"/>
      <geometry><box size="0.1 0.1 0.1"/></geometry>
    </collision>
  </link>
  <link name="finger">
    <collision>
      <geometry><box size="0.04 0.04 0.04"/></geometry>
    </collision>
  </link>
  <joint name="lift" type="prismatic">
    <parent link="base"/>
    <child link="slide"/>
    <axis xyz="0 0 1"/>
    <limit lower="0" upper="0.1" effort="10" velocity="1"/>
  </joint>
  <joint name="reach" type="prismatic">
    <parent link="slide"/>
    <child link="finger"/>
    <axis xyz="1 0 0"/>
    <limit lower="0.1" upper="0.2" effort="10" velocity="1"/>
  </joint>
</robot>
)"}},
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::links_overlap
