// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is said of the wheels of a drive whose axes point the wrong way, by a plugin or by ros2_control.

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {
namespace {

using Said = std::vector<std::string>;

const Said kNothingSaid;

/// The messages of drive-wheels-inconsistent in a URDF.
Said said_of(const std::string& inside) {
  const MemoryDisk disk(std::map<std::string, std::string>{
      {"a.urdf", "<robot name='r'><link name='base'/>" + inside + "</robot>"}});
  const Environment environment(disk, {});
  Sources sources;
  Said said;
  const ValidateResult result = validate(environment, {.paths = {"a.urdf"}}, sources);
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    if (diagnostic.rule == "drive-wheels-inconsistent") said.push_back(diagnostic.message);
  }
  return said;
}

/// At this y, rolled about x as `rpy` says, and turning about an axis of its own.
std::string wheel(const std::string& side, const std::string& y, const std::string& roll,
                  const std::string& axis) {
  const std::string name = side + "_wheel";
  return "<link name='" + name +
         "'><collision><geometry><cylinder radius='0.1' length='0.04'/></geometry></collision>"
         "</link><joint name='" +
         name + "_joint' type='continuous'><parent link='base'/><child link='" + name +
         "'/><origin xyz='0 " + y + " 0' rpy='" + roll + " 0 0'/><axis xyz='" + axis +
         "'/></joint>";
}

std::string wheels(const std::string& roll, const std::string& left_axis,
                   const std::string& right_axis) {
  return wheel("left", "0.2", roll, left_axis) + wheel("right", "-0.2", roll, right_axis);
}

std::string plugin(const std::string& left, const std::string& right) {
  return "<gazebo><plugin filename='gz-sim-diff-drive-system' name='gz::sim::systems::DiffDrive'>"
         "<left_joint>" +
         left + "_wheel_joint</left_joint><right_joint>" + right +
         "_wheel_joint</right_joint><wheel_separation>0.4</wheel_separation></plugin></gazebo>";
}

std::string control(const std::string& interface) {
  std::string joints;
  for (const char* side : {"left", "right"}) {
    joints += "<joint name='" + std::string(side) + "_wheel_joint'><command_interface name='" +
              interface + "'/></joint>";
  }
  return "<ros2_control name='c' type='system'><hardware><plugin>p/P</plugin></hardware>" + joints +
         "</ros2_control>";
}

TEST(DriveWheels, AxesThatPointToTheRightDriveBackwards) {
  const std::string backwards = wheels("1.5708", "0 0 1", "0 0 1");
  EXPECT_EQ(
      said_of(backwards + plugin("left", "right")),
      Said{"the axes of the wheels 'left_wheel_joint' and 'right_wheel_joint' both point to -y: "
           "the robot drives backwards and turns the wrong way"});
  EXPECT_EQ(said_of(wheels("-1.5708", "0 0 1", "0 0 1") + plugin("left", "right")), kNothingSaid);
}

TEST(DriveWheels, ExchangedJointsAreSaidToBe) {
  const std::string good = wheels("-1.5708", "0 0 1", "0 0 1");
  EXPECT_EQ(said_of(good + plugin("right", "left")),
            Said{"the left wheel 'right_wheel_joint' is on the right of 'left_wheel_joint' as "
                 "their axes rotate: the robot turns the wrong way"});
}

TEST(DriveWheels, OfRos2ControlAreComparedByTheirNames) {
  const std::string opposed = wheels("-1.5708", "0 0 1", "0 0 -1");
  EXPECT_EQ(said_of(opposed + control("velocity")),
            Said{"the axis of 'right_wheel_joint' points to -y and that of 'left_wheel_joint' to "
                 "+y: commanded straight ahead, the robot rotates"});
  // Steered to an angle, each by its own.
  EXPECT_EQ(said_of(opposed + control("position")), kNothingSaid);
  EXPECT_EQ(said_of(opposed), kNothingSaid);
  EXPECT_EQ(said_of(wheels("-1.5708", "0 0 1", "0 0 1") + control("velocity")), kNothingSaid);
  // A plugin says which is which.
  EXPECT_EQ(said_of(opposed + control("velocity") + plugin("left", "right")).size(), 1U);
}

}  // namespace
}  // namespace rigor::rules
