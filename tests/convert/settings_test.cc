// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What two models tell simulators, each changed by hand in one place.

#include <rigor/convert/settings.h>

#include <gtest/gtest.h>

#include <convert/converted.h>
#include <robot/robots.h>

namespace rigor::test {
namespace {

using Lines = std::vector<std::string>;

using Compare = std::vector<robot::Difference> (*)(const convert::SettingsSource&,
                                                   const convert::SettingsSource&);

/// "setting link a gravity: true > false", one for each.
Lines differences(const std::string& a, const std::string& b,
                  Compare compare = convert::compare_settings) {
  const auto path = [](const std::string& text) {
    if (text.find("<mujoco") != std::string::npos) return "a.xml";
    return text.find("<sdf") == std::string::npos ? "a.urdf" : "a.sdf";
  };
  const MemoryDisk disk_a(std::map<std::string, std::string>{{path(a), a}});
  const MemoryDisk disk_b(std::map<std::string, std::string>{{path(b), b}});
  const ReadRobot read_a(disk_a, path(a)), read_b(disk_b, path(b));
  Lines lines;
  for (const auto& d : compare({read_a.loaded.root, read_a.documents, sdf_schema(), {0}},
                               {read_b.loaded.root, read_b.documents, sdf_schema(), {0}})) {
    std::string line = std::string(to_string(d.kind)) + ' ' + (d.a.empty() ? d.b : d.a);
    if (!d.what.empty()) line += ' ' + d.what + ": " + d.from.text + " > " + d.to.text;
    lines.push_back(line);
  }
  return lines;
}

const std::string kSdf = R"(<sdf version="1.9"><model name="m"><self_collide>0</self_collide>
<link name="a"><gravity>true</gravity>
<collision name="c"><geometry><sphere><radius>0.5</radius></sphere></geometry>
<surface><friction><ode><mu>0.50</mu></ode></friction></surface></collision>
<sensor name="s" type="camera"><update_rate>30</update_rate>
<camera><horizontal_fov>1.5</horizontal_fov></camera></sensor></link>
<plugin filename="drive" name="Drive"><wheel>0.1</wheel><joint>l</joint><joint>r</joint></plugin>
</model></sdf>)";

TEST(Settings, OneThingThatDiffersIsOneDifference) {
  const auto after = [](const std::string& from, const std::string& to) {
    return differences(kSdf, with(kSdf, from, to));
  };
  EXPECT_EQ(after("m", "m"), Lines{});
  EXPECT_EQ(after("0.50", "0.7"),
            Lines{"setting collision a/c surface/friction/ode/mu: 0.50 > 0.7"});
  EXPECT_EQ(after("<gravity>true", "<gravity>0"), Lines{"setting link a gravity:  > 0"});
  EXPECT_EQ(after("<self_collide>0", "<self_collide>1"), Lines{"setting robot self_collide:  > 1"});
  EXPECT_EQ(after("<update_rate>30", "<update_rate>10"),
            Lines{"setting sensor a/s update_rate: 30 > 10"});
  EXPECT_EQ(after("\"camera\"", "\"depth\""), Lines{"setting sensor a/s type: camera > depth"});
  EXPECT_EQ(after("1.5", "1.2"), Lines{"setting sensor a/s camera/horizontal_fov: 1.5 > 1.2"});
  EXPECT_EQ(after("name=\"s\"", "name=\"t\""),
            (Lines{"attachment-only-in-a sensor a/s", "attachment-only-in-b sensor a/t"}));
  EXPECT_EQ(after("<joint>r", "<joint>x"), Lines{"setting plugin Drive joint[2]: r > x"});
  EXPECT_EQ(after("name=\"Drive\"", "name=\"Other\"").size(), 2U);
}

TEST(Settings, WhatMeansTheSameIsNoDifference) {
  EXPECT_EQ(differences(kSdf, with(kSdf, "0.50", "5e-1")), Lines{});
  EXPECT_EQ(differences(kSdf, with(kSdf, "<gravity>true</gravity>", "")), Lines{});
  EXPECT_EQ(differences(kSdf, with(kSdf, "radius>0.5", "radius>0.6")), Lines{}) << "compare.h's";
}

TEST(Settings, OfAUrdfTheyAreInBlocks) {
  const std::string urdf = R"(<robot name="r"><link name="a"/><gazebo reference="a"><mu1>0.5</mu1>
<sensor name="s" type="imu"/></gazebo><gazebo><plugin name="p" filename="p.so"/></gazebo></robot>)";
  EXPECT_EQ(differences(urdf, urdf), Lines{});
  EXPECT_EQ(differences(urdf, with(urdf, "0.5", "0.7")), Lines{"setting link a mu1: 0.5 > 0.7"});
  EXPECT_EQ(differences(urdf, with(urdf, "imu", "gps")),
            Lines{"setting sensor a/s type: imu > gps"});
  EXPECT_EQ(differences(urdf, with(urdf, "name=\"p\"", "name=\"q\"")),
            (Lines{"attachment-only-in-a plugin p", "attachment-only-in-b plugin q"}));
}

/// A spring of a URDF joint stands in a block too, and is a number of the joint.
TEST(Settings, ASpringIsTheJoints) {
  const std::string urdf = R"(<robot name="r"><link name="a"/><link name="b"/><joint name="j"
type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
<gazebo reference="j"><springStiffness>20</springStiffness></gazebo></robot>)";
  const std::string stiffer = with(urdf, "20", "30");
  EXPECT_EQ(told(all_differences(urdf, urdf)), Lines{});
  EXPECT_EQ(told(all_differences(urdf, stiffer)), Lines{"spring-stiffness joint j"});
  EXPECT_EQ(differences(urdf, stiffer), Lines{});
}

Lines further(const std::string& text, const std::string& from, const std::string& to) {
  return differences(text, with(text, from, to), convert::compare_further_settings);
}

TEST(Settings, AReviewSeesSoftLimitsTransmissionsAndControl) {
  const std::string urdf = R"(<robot name="r"><link name="a"/><link name="b"/><joint name="j"
type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
<safety_controller soft_lower_limit="-1" k_velocity="5"/></joint>
<transmission name="t"><actuator name="m"><mechanicalReduction>50</mechanicalReduction></actuator></transmission>
<ros2_control name="s" type="system"><hardware><plugin>p</plugin></hardware></ros2_control></robot>)";
  EXPECT_EQ(further(urdf, "r", "r"), Lines{});
  EXPECT_EQ(further(urdf, "\"-1\"", "\"-0.5\""),
            Lines{"setting joint j safety_controller/soft_lower_limit: -1 > -0.5"});
  EXPECT_EQ(further(urdf, "50<", "5<"),
            Lines{"setting transmission t actuator/mechanicalReduction: 50 > 5"});
  EXPECT_EQ(further(urdf, ">p<", ">q<"), Lines{"setting ros2_control s hardware/plugin: p > q"});
  EXPECT_EQ(further(urdf, "<ros2_control name=\"s\"", "<ros2_control name=\"x\""),
            (Lines{"attachment-only-in-a ros2_control s", "attachment-only-in-b ros2_control x"}));
  EXPECT_EQ(differences(urdf, with(urdf, "\"-1\"", "\"-0.5\"")), Lines{}) << "edits change it";
}

TEST(Settings, AReviewSeesTheStiffnessOfLimits) {
  const std::string sdf = R"(<sdf version="1.9"><model name="m"><link name="a"/><link name="b"/>
<joint name="j" type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz>
<limit><lower>0</lower><upper>1</upper><stiffness>100</stiffness></limit></axis></joint></model></sdf>)";
  EXPECT_EQ(further(sdf, "100", "1e2"), Lines{});
  EXPECT_EQ(further(sdf, "100", "200"), Lines{"setting joint j axis/limit/stiffness: 100 > 200"});
}

TEST(Settings, AReviewSeesTheWorldAndTheFlagsOfVisuals) {
  const std::string sdf = R"(<sdf version="1.9"><world name="w"><gravity>0 0 -9.7</gravity>
<physics name="p" type="ode"><max_step_size>0.002</max_step_size></physics><light name="sun" type="directional"/>
<model name="m"><link name="a"><visual name="v"><geometry><sphere><radius>1</radius></sphere></geometry>
<cast_shadows>false</cast_shadows></visual></link></model></world></sdf>)";
  EXPECT_EQ(further(sdf, "0.002", "2e-3"), Lines{});
  EXPECT_EQ(further(sdf, "-9.7", "-1.6"), Lines{"setting world gravity: 0 0 -9.7 > 0 0 -1.6"});
  EXPECT_EQ(further(sdf, "0.002", "0.1"),
            Lines{"setting world physics/max_step_size: 0.002 > 0.1"});
  EXPECT_EQ(further(sdf, "<light name=\"sun\" type=\"directional\"/>", ""),
            Lines{"attachment-only-in-a light sun"});
  EXPECT_EQ(further(sdf, "<cast_shadows>false</cast_shadows>", ""),
            Lines{"setting visual a/v cast_shadows: false > "});
}

TEST(Settings, AReviewSeesArmatureAndFrictionOfMjcf) {
  const std::string mjcf = R"(<mujoco><default><geom friction="0.7"/></default><worldbody>
<body name="a"><joint name="j" armature="0.01"/><geom name="g" size="0.1"/></body></worldbody></mujoco>)";
  EXPECT_EQ(further(mjcf, "0.7", "0.70"), Lines{});
  EXPECT_EQ(further(mjcf, "0.7", "0.1"), Lines{"setting collision a/g friction: 0.7 > 0.1"});
  EXPECT_EQ(further(mjcf, "0.01", "0.5"), Lines{"setting joint j armature: 0.01 > 0.5"});
}

}  // namespace
}  // namespace rigor::test
