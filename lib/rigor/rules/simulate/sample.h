// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Models that pass their tests, for the good examples of rules on simulations.

#pragma once

#include <string_view>

namespace rigor::rules {

/// Stands.
inline constexpr std::string_view kStandingBox = R"(<sdf version='1.9'>
  <model name='crate'>
    <link name='body'>
      <pose>0 0 0.1 0 0 0</pose>
      <inertial>
        <mass>6</mass>
        <inertia><ixx>0.04</ixx><iyy>0.04</iyy><izz>0.04</izz></inertia>
      </inertial>
      <collision name='c'>
        <geometry><box><size>0.2 0.2 0.2</size></box></geometry>
      </collision>
    </link>
  </model>
</sdf>
)";

/// Drives straight, turns and stops.
inline constexpr std::string_view kCart = R"(<sdf version='1.11'>
  <model name='cart'>
    <link name='body'>
      <pose>0 0 0.1 0 0 0</pose>
      <inertial auto='true'/>
      <collision name='box'>
        <geometry><box><size>0.3 0.2 0.05</size></box></geometry>
      </collision>
      <collision name='caster'>
        <pose>-0.1 0 -0.05 0 0 0</pose>
        <geometry><sphere><radius>0.05</radius></sphere></geometry>
        <surface><friction><ode><mu>0</mu><mu2>0</mu2></ode></friction></surface>
      </collision>
    </link>
    <link name='left'>
      <pose>0.05 0.13 0.1 0 0 0</pose>
      <inertial auto='true'/>
      <collision name='tyre'>
        <pose>0 0 0 1.5707963 0 0</pose>
        <geometry><cylinder><radius>0.1</radius><length>0.03</length></cylinder></geometry>
      </collision>
    </link>
    <link name='right'>
      <pose>0.05 -0.13 0.1 0 0 0</pose>
      <inertial auto='true'/>
      <collision name='tyre'>
        <pose>0 0 0 1.5707963 0 0</pose>
        <geometry><cylinder><radius>0.1</radius><length>0.03</length></cylinder></geometry>
      </collision>
    </link>
    <joint name='left_hinge' type='revolute'>
      <parent>body</parent>
      <child>left</child>
      <axis><xyz>0 1 0</xyz></axis>
    </joint>
    <joint name='right_hinge' type='revolute'>
      <parent>body</parent>
      <child>right</child>
      <axis><xyz>0 1 0</xyz></axis>
    </joint>
  </model>
</sdf>
)";

/// Holds itself up.
inline constexpr std::string_view kArm = R"(<sdf version='1.9'>
  <model name='crane'>
    <link name='arm'>
      <pose>0 0 1 0 0 0</pose>
      <inertial>
        <pose>0.2 0 0 0 0 0</pose>
        <mass>1</mass>
        <inertia><ixx>0.001</ixx><iyy>0.02</iyy><izz>0.02</izz></inertia>
      </inertial>
    </link>
    <joint name='shoulder' type='revolute'>
      <parent>world</parent>
      <child>arm</child>
      <axis>
        <xyz>0 1 0</xyz>
        <limit><lower>-1</lower><upper>1</upper><effort>10</effort></limit>
      </axis>
    </joint>
  </model>
</sdf>
)";

}  // namespace rigor::rules
