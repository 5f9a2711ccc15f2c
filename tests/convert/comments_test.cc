// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/comments.h>

#include <gtest/gtest.h>

#include <string>

#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/convert/urdf_to_sdf.h>

#include "convert/converted.h"
#include "convert/loaded_robot.h"

namespace rigor::convert {
namespace {

/// Without the lines before the link or joint of a name, and after it.
std::string part_of(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t first = text.find(begin);
  EXPECT_NE(first, std::string::npos) << text;
  if (first == std::string::npos) return {};
  return text.substr(first, text.find(end, first) + end.size() - first);
}

TEST(Comments, OfAnSdfFileStandWhereTheyDid) {
  const test::Converted converted(
      std::map<std::string, std::string>{{"robot.sdf", R"(<?xml version='1.0'?>
<!-- Copyright of the arm -->
<sdf version='1.9'>
  <model name='m'>
    <!-- the base -->
    <link name='base'> <!-- on its line -->
      <inertial>
        <!-- kg -->
        <mass>1</mass>
        <inertia> <!-- made up -->
          <ixx>1</ixx> <iyy>1</iyy>
          <!-- about z -->
          <izz>1</izz>
        </inertia>
      </inertial>
      <!-- what is seen -->
      <visual name='v'>
        <!-- moved up -->
        <pose>0 0 1 0 0 0</pose>
        <geometry>
          <box>
            <size>1 2 3</size> <!-- m -->
          </box>
        </geometry>
        <!-- no color -->
      </visual> <!-- of the visual -->
      <!-- lost with its plane -->
      <collision name='c'><geometry><plane/></geometry></collision>
      <!-- nothing else -->
    </link>
    <link name='arm'><inertial><mass>1</mass></inertial></link>
    <joint name='j' type='revolute'>
      <parent>base</parent>
      <child>arm</child>
      <axis>
        <!-- up -->
        <xyz>0 0 1</xyz>
        <limit>
          <lower>-1</lower>
          <!-- measured -->
          <upper>1</upper>
          <effort>1</effort>
          <velocity>1</velocity>
        </limit>
      </axis>
    </joint>
  </model>
</sdf>
)"}});
  const std::string text = urdf_text(*converted.result.robot);
  EXPECT_EQ(text.find("<!-- Copyright of the arm -->\n<robot"), text.find("<!--")) << text;
  EXPECT_EQ(part_of(text, "  <!-- the base -->", "</link>"), R"(  <!-- the base -->
  <!-- on its line -->
  <link name="base">
    <inertial>
      <!-- kg -->
      <mass value="1"/>
      <!-- made up -->
      <!-- about z -->
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
    </inertial>
    <!-- what is seen -->
    <!-- of the visual -->
    <visual name="v">
      <!-- moved up -->
      <origin xyz="0 0 1"/>
      <geometry>
        <!-- m -->
        <box size="1 2 3"/>
      </geometry>
      <!-- no color -->
    </visual>
    <!-- nothing else -->
  </link>)");
  EXPECT_EQ(part_of(text, "    <!-- up -->", "velocity=\"1\"/>"), R"(    <!-- up -->
    <axis xyz="0 0 1"/>
    <!-- measured -->
    <limit lower="-1" upper="1" effort="1" velocity="1"/>)");
}

TEST(Comments, OfAUrdfFileStandWhereTheyDid) {
  const test::LoadedRobot robot(R"(<?xml version="1.0"?>
<!--
  Converted from a.sdf by rigor.
  Elements and attributes: 1 converted. -->
<!-- Copyright of the arm -->
<robot name="r">
  <!-- the base -->
  <link name="base">
    <inertial> <!-- guessed -->
      <origin xyz="0 0 1"/> <!-- its middle -->
      <mass value="1"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
    </inertial>
  </link>
  <!-- a mere frame -->
  <joint name="f" type="fixed">
    <parent link="base"/>
    <child link="tip"/>
    <origin xyz="0 0 2"/>
  </joint>
  <!-- at its end -->
  <link name="tip"/>
  <link name="arm">
    <inertial>
      <mass value="1"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
    </inertial>
  </link>
  <joint name="j" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <!-- it has no origin -->
    <axis xyz="0 0 1"/>
    <!-- from the data sheet -->
    <limit lower="-1" upper="1" effort="3" velocity="2"/>
  </joint>
</robot>
)");
  const std::string text = sdf_text(*urdf_to_sdf(robot.source(), {}).robot);
  EXPECT_EQ(text.find("<!-- Copyright of the arm -->\n<sdf"), text.find("<!--")) << text;
  EXPECT_EQ(part_of(text, "    <!-- the base -->", "<mass>"), R"(    <!-- the base -->
    <link name="base">
      <!-- guessed -->
      <inertial>
        <!-- its middle -->
        <pose>0 0 1 0 0 0</pose>
        <mass>)");
  EXPECT_EQ(part_of(text, "    <!-- a mere frame -->", "\"f\"/>"), R"(    <!-- a mere frame -->
    <frame name="f" attached_to="base">
      <pose>0 0 2 0 0 0</pose>
    </frame>
    <!-- at its end -->
    <frame name="tip" attached_to="f"/>)");
  EXPECT_NE(text.find("      <!-- it has no origin -->\n      <axis>"), std::string::npos) << text;
  EXPECT_NE(text.find("        <!-- from the data sheet -->\n        <limit>"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace rigor::convert
