// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is in a `<gazebo reference>` of a URDF, or is a sensor of the robot, goes with its link: positions by hand.

#include <gtest/gtest.h>

#include <rigor/author/verbs/lump/lump.h>
#include <rigor/author/verbs/mirror.h>
#include <rigor/author/verbs/move_frame.h>
#include <rigor/author/verbs/reroot.h>
#include <rigor/author/verbs/scale.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

constexpr const char* kCamera = R"(<robot name="r">
  <link name="base"/>
  <joint name="j" type="fixed">
    <origin xyz="0.3 0.1 0.5"/>
    <parent link="base"/>
    <child link="cam"/>
  </joint>
  <link name="cam"/>
  <gazebo reference="cam">
    <sensor name="c" type="camera"><pose>0.01 0.02 0.03 0 0 0</pose><camera><pose>1 1 1 0 0 0</pose></camera></sensor>
    <sensor name="i" type="imu"/>
    <light name="l" type="point"><pose degrees="true">0 0 0.25 0 0 90</pose></light>
  </gazebo>
  <sensor name="s">
    <parent link="cam"/>
    <origin xyz="0 0 1"/>
  </sensor>
  <gazebo reference="base"><sensor name="b" type="imu"><pose>1 0 0 0 0 0</pose></sensor></gazebo>
</robot>
)";

class GazeboPose : public testing::Test {
 protected:
  GazeboPose() : bench_({{"r.urdf", kCamera}}), robot_(bench_.open("r.urdf")) {}

  std::string changed(const Change& change) { return bench_.text(robot_, change); }

  /// As the reader has it, which the verbs do not ask.
  static void expect_sensor(const EditedModel& robot, const std::string& name,
                            const std::string& link, const model::Vector3& position) {
    for (const model::Sensor& sensor : robot.root().sensors) {
      if (sensor.name.value != name) continue;
      EXPECT_EQ(sensor.gazebo_reference, link) << name;
      const model::Vector3& p = sensor.pose.pose.value.translation;
      EXPECT_NEAR(p.x, position.x, 1e-12) << name;
      EXPECT_NEAR(p.y, position.y, 1e-12) << name;
      EXPECT_NEAR(p.z, position.z, 1e-12) << name;
      return;
    }
    ADD_FAILURE() << "no sensor " << name;
  }

  void expect_sensors(const std::string& text, const std::string& link, const model::Vector3& c,
                      const model::Vector3& i) {
    const EditedModel& after = bench_.open_text("r.urdf", text);
    expect_sensor(after, "c", link, c);
    expect_sensor(after, "i", link, i);
    EXPECT_NE(text.find("<camera><pose>1 1 1 0 0 0</pose></camera>"), std::string::npos) << text;
    const std::size_t block = text.find("<gazebo"), end = text.find("</gazebo>");
    EXPECT_EQ(text.substr(block, end - block).find("<origin"), std::string::npos) << text;
  }

  static void expect_text(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }

  VerbBench bench_;
  const EditedModel& robot_;
};

TEST_F(GazeboPose, OfALumpedLink) {
  const std::string text = changed(lumped(robot_, {}));
  expect_sensors(text, "base", {0.31, 0.12, 0.53}, {0.3, 0.1, 0.5});
  expect_text(text, "<pose degrees=\"true\">0.3 0.1 0.75 0 0 90</pose></light>");
  expect_text(text, "<parent link=\"base\"/>\n    <origin xyz=\"0.3 0.1 1.5\"/>");
  expect_sensor(bench_.open_text("r.urdf", text), "b", "base", {1, 0, 0});
}

TEST_F(GazeboPose, OfAScaledRobot) {
  const std::string text = changed(scaled(robot_, 2, {}));
  expect_sensors(text, "cam", {0.02, 0.04, 0.06}, {0, 0, 0});
  expect_text(text, "<pose degrees=\"true\">0 0 0.5 0 0 90</pose></light>");
  expect_text(text, "<parent link=\"cam\"/>\n    <origin xyz=\"0 0 2\"/>");
}

TEST_F(GazeboPose, OfALinkWithAnotherFrame) {
  const std::string text = changed(with_frame(robot_, "cam", {{0.1, 0, 0}, {}}));
  expect_sensors(text, "cam", {-0.09, 0.02, 0.03}, {-0.1, 0, 0});
  expect_text(text, "<pose degrees=\"true\">-0.1 0 0.25 0 0 90</pose></light>");
  expect_text(text, "<origin xyz=\"-0.1 0 1\"/>");
}

TEST_F(GazeboPose, OfAMirroredPart) {
  const std::string text = changed(mirrored(robot_, "cam", {}));
  expect_sensors(text, "cam", {0.01, -0.02, 0.03}, {0, 0, 0});
  expect_text(text, "<pose degrees=\"true\">0 0 0.25 0 0 -90</pose></light>");
}

TEST_F(GazeboPose, OfAFormerRoot) {
  const std::string text = changed(rerooted(robot_, "cam"));
  expect_sensors(text, "cam", {0.01, 0.02, 0.03}, {0, 0, 0});
  expect_sensor(bench_.open_text("r.urdf", text), "b", "base", {0.7, -0.1, -0.5});
}

}  // namespace
}  // namespace rigor::author
