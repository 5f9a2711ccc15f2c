// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Models that convert exactly: the good examples of the rules on conversions.

#pragma once

#include <string_view>

namespace rigor::rules {

inline constexpr std::string_view kSdfLink = R"(<sdf version='1.9'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
  </model>
</sdf>
)";

inline constexpr std::string_view kSdfArm = R"(<sdf version='1.9'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <link name='tip'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <joint name='elbow' type='revolute'>
      <parent>base</parent>
      <child>tip</child>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <lower>-1</lower>
          <upper>1</upper>
          <effort>5</effort>
          <velocity>2</velocity>
        </limit>
      </axis>
    </joint>
  </model>
</sdf>
)";

inline constexpr std::string_view kUrdfLink = R"(<robot name='arm'>
  <link name='base'>
    <inertial>
      <mass value='1'/>
      <inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>
    </inertial>
  </link>
</robot>
)";

}  // namespace rigor::rules
