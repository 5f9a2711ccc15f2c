// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// add: what is added passes every rule that is on by default.

#include <rigor/author/verbs/add.h>

#include <gtest/gtest.h>

#include <rigor/rules/validate.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

std::string findings_in(VerbBench& bench, const std::string& path, const std::string& text) {
  Sources sources;
  rules::ValidateOptions options;
  options.buffer = {path, text};
  const rules::ValidateResult result = rules::validate(bench.environment(), options, sources);
  std::string found;
  for (const Diagnostic& each : result.diagnostics.list()) {
    if (each.severity != Severity::kInfo)
      found += std::string(each.rule) + ": " + each.message + '\n';
  }
  return found;
}

constexpr const char* kSensed = R"(<link name="base">
    <inertial>
      <mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
    </inertial>
    <collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
  </link>
  <joint name="turn" type="continuous">
    <origin xyz="0 0 0.2"/>
    <parent link="base"/>
    <child link="head"/>
    <axis xyz="0 0 1"/>
    <limit effort="1" velocity="1"/>
  </joint>
  <link name="head">
    <inertial>
      <mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
    </inertial>
    <collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
  </link>
)";

TEST(Add, SensorsPassTheRules) {
  const std::string urdf = "<robot name=\"r\">\n  " + std::string(kSensed) + "</robot>\n";
  for (const std::string version : {"1.6", "1.7", "1.9"}) {
    const std::string sdf = "<?xml version=\"1.0\"?>\n<sdf version=\"" + version + R"(">
  <model name="m">
    <link name="head">
      <inertial>
        <mass>1</mass>
        <inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia>
      </inertial>
      <collision name="c"><geometry><box><size>0.2 0.2 0.2</size></box></geometry></collision>
    </link>
  </model>
</sdf>
)";
    VerbBench bench({{"m.sdf", sdf}, {"r.urdf", urdf}});
    for (const char* path : {"m.sdf", "r.urdf"}) {
      const EditedModel& model = bench.open(path);
      const std::string before = findings_in(bench, path, std::string(model.document().bytes()));
      for (const SensorTemplate kind :
           {SensorTemplate::kCamera, SensorTemplate::kImu, SensorTemplate::kLidar}) {
        const std::string text =
            bench.text(model, with_sensor(model, kind, "head", {{0.1, 0, 0}, {}}));
        EXPECT_EQ(findings_in(bench, path, text), before) << text;
        const EditedModel& with = bench.open_text(path, text);
        ASSERT_EQ(with.root().sensors.size(), 1U);
        EXPECT_EQ(with.root().sensors[0].pose.pose.value.translation, (model::Vector3{0.1, 0, 0}));
        const EditedModel& both =
            bench.open_text(path, bench.text(with, with_sensor(with, kind, "head", {})));
        ASSERT_EQ(both.root().sensors.size(), 2U);
        EXPECT_TRUE(both.root().sensors[1].name.value.ends_with("_2"));
      }
    }
  }
}

TEST(Add, HardwareForAllJointsThatMove) {
  const std::string urdf = "<robot name=\"r\">\n  " + std::string(kSensed) + "</robot>\n";
  VerbBench bench({{"r.urdf", urdf}});
  const EditedModel& robot = bench.open("r.urdf");
  const std::string text = bench.text(robot, with_ros2_control(robot));
  EXPECT_EQ(text, urdf.substr(0, urdf.find("</robot>")) +
                      R"(  <ros2_control name="r" type="system">
    <hardware>
      <plugin>mock_components/GenericSystem</plugin>
    </hardware>
    <joint name="turn">
      <command_interface name="velocity"/>
      <state_interface name="position"/>
      <state_interface name="velocity"/>
    </joint>
  </ros2_control>
</robot>
)");
  EXPECT_EQ(findings_in(bench, "r.urdf", text), findings_in(bench, "r.urdf", urdf));
  const EditedModel& controlled = bench.open_text("r.urdf", text);
  EXPECT_EQ(with_ros2_control(controlled).refused, "it has a <ros2_control> already");
}

}  // namespace
}  // namespace rigor::author
