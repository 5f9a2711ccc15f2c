// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/moved_paths.h>

#include <gtest/gtest.h>

namespace rigor::author {
namespace {

TEST(MovedText, EveryRelativeUriLeadsWhereItLed) {
  EXPECT_EQ(moved_text(R"(<robot name="a">
  <material name="m"><texture filename="pictures/a&amp;b.png"/></material>
  <link name="b">
    <visual><geometry><mesh filename="meshes/b.stl"/></geometry></visual>
    <collision><geometry><mesh filename="../b.stl"/></geometry></collision>
  </link>
</robot>)",
                       "/arm/urdf/a.urdf", "/build/a.urdf"),
            R"(<robot name="a">
  <material name="m"><texture filename="../arm/urdf/pictures/a&amp;b.png"/></material>
  <link name="b">
    <visual><geometry><mesh filename="../arm/urdf/meshes/b.stl"/></geometry></visual>
    <collision><geometry><mesh filename="../arm/b.stl"/></geometry></collision>
  </link>
</robot>)");
  EXPECT_EQ(moved_text(R"(<sdf version="1.9"><model name="m">
  <include><uri>wheel</uri></include>
  <link name="b"><visual name="v">
    <geometry><mesh><uri>
      b.dae </uri></mesh></geometry>
    <material>
      <script><uri>materials/scripts</uri><uri>materials/textures</uri></script>
      <pbr><metal><albedo_map>a&amp;b.png</albedo_map></metal></pbr>
    </material>
  </visual></link>
</model></sdf>)",
                       "m/model.sdf", "m/old/model.sdf"),
            R"(<sdf version="1.9"><model name="m">
  <include><uri>../wheel</uri></include>
  <link name="b"><visual name="v">
    <geometry><mesh><uri>
      ../b.dae </uri></mesh></geometry>
    <material>
      <script><uri>../materials/scripts</uri><uri>../materials/textures</uri></script>
      <pbr><metal><albedo_map>../a&amp;b.png</albedo_map></metal></pbr>
    </material>
  </visual></link>
</model></sdf>)");
}

TEST(MovedText, OtherUrisAndOtherFilenamesStay) {
  const std::string text = R"(<robot name="a">
  <xacro:include filename="$(find a)/b.xacro"/>
  <link name="b">
    <visual><geometry><mesh filename="package://a/b.stl"/></geometry></visual>
    <visual><geometry><mesh filename="/meshes/b.stl"/></geometry></visual>
    <visual><geometry><mesh filename=""/></geometry></visual>
  </link>
  <gazebo><plugin name="p" filename="lib.so"><uri>topic</uri></plugin></gazebo>
</robot>)";
  EXPECT_EQ(moved_text(text, "/arm/a.urdf", "/build/a.urdf"), text);
}

TEST(MovedText, InItsFolderNothingChanges) {
  const std::string text = R"(<robot name="a"><link name="b"><visual><geometry>
<mesh filename="./meshes/../b.stl"/></geometry></visual></link></robot>)";
  EXPECT_EQ(moved_text(text, "/arm/a.urdf", "/arm/./b.urdf"), text);
}

}  // namespace
}  // namespace rigor::author
