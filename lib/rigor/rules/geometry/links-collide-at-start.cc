// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/geometry/overlapping_links.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::links_collide_at_start {
namespace {

void check(const model::Root& root, Context& context) {
  if (root.links.size() < 2 || root.collisions.size() < 2) return;
  const SelfColliding self_colliding(root, context);
  // Nearly no file says it, so that the others need not be measured.
  if (!self_colliding.any()) return;
  for (const auto& [top, pairs] : lasting_overlaps(root, context.frames())) {
    if (!root.own(root[top].site)) continue;
    std::vector<LinkOverlap> pushed;
    for (const LinkOverlap& pair : pairs) {
      if (self_collide(pair, self_colliding)) pushed.push_back(pair);
    }
    report_overlaps(root[top], pushed, "at the start and may collide (self_collide)", context);
  }
}

}  // namespace

Rule rule() {
  return {
      .name = "links-collide-at-start",
      .category = Category::kGeometry,
      .severity = Severity::kWarning,
      .summary = "links of a model that may collide with itself overlap",
      .why =
          "With <self_collide> the links of a model collide, except those that a joint connects. "
          "Two "
          "that are in each other at the start are pushed apart at the first step: the model "
          "jumps, "
          "or trembles for as long as a joint keeps them there. Boxes, balls, cylinders and the "
          "like "
          "are looked at, meshes are not.",
      .what_to_do =
          "Make the collisions smaller, or move them apart; or take <self_collide> from the links.",
      .bad = {{R"(<sdf version="1.9">
  <«model» name="arm">
    <self_collide>true</self_collide>
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
  <gazebo reference="left">
    <selfCollide>true</selfCollide>
  </gazebo>
</robot>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <self_collide>true</self_collide>
    <link name="base">
      <collision name="block">
        <geometry><box><size>0.2 0.2 0.1</size></box></geometry>
      </collision>
    </link>
    <link name="upper">
      <pose>0 0 0.1 0 0 0</pose>
      <collision name="tube">
        <geometry><cylinder><radius>0.03</radius><length>0.2</length></cylinder></geometry>
      </collision>
    </link>
    <joint name="shoulder" type="revolute">
      <parent>base</parent>
      <child>upper</child>
      <axis><xyz>0 1 0</xyz></axis>
    </joint>
  </model>
</sdf>
)"}},
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::links_collide_at_start
