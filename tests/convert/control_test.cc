// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Transmissions in the words of Gazebo Sim and of ros2_control: what becomes of them, and what is lost.

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include <rigor/convert/urdf_to_sdf.h>

#include "convert/loaded_robot.h"

namespace rigor::convert {
namespace {

/// Two joints that move, j and k, and one that does not, with `blocks` beside them.
struct DrivenRobot {
  explicit DrivenRobot(const std::string& blocks,
                       ControlPolicy control = ControlPolicy::kRos2Control)
      : robot("<robot name='r'>" + link("a") + link("b") + link("c") + link("d") +
              joint("j", "continuous", "b") + joint("k", "continuous", "c") +
              joint("f", "fixed", "d") + blocks + "</robot>"),
        result(urdf_to_sdf(robot.source(), options(control))) {}

  static std::string link(const std::string& name) {
    return "<link name='" + name +
           "'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
           "izz='1'/></inertial></link>";
  }
  static std::string joint(const std::string& name, const std::string& type,
                           const std::string& child) {
    return "<joint name='" + name + "' type='" + type + "'><parent link='a'/><child link='" +
           child + "'/></joint>";
  }
  static SdfOptions options(ControlPolicy control) {
    SdfOptions chosen;
    chosen.control = control;
    return chosen;
  }

  /// The block beside the result, without white space between its tags.
  std::string block() const {
    for (const SideFile& file : result.files) {
      if (file.name.find("ros2_control") == std::string::npos) continue;
      std::string text;
      bool space = true;
      for (const char c : file.bytes) {
        space = c == '\n' || (space && c == ' ');
        if (!space) text += c;
      }
      return text;
    }
    return {};
  }
  bool has_plugin(const std::string& name) const {
    return sdf_text(*result.robot).find("gz::sim::systems::" + name + '"') != std::string::npos;
  }
  std::vector<std::string> losses() const {
    std::vector<std::string> found;
    for (const Note& note : result.account.notes) {
      if (note.outcome == Outcome::kLost) found.push_back(note.written + ' ' + note.instead);
    }
    return found;
  }
  std::vector<std::string> written() const {
    std::vector<std::string> found;
    for (const Note& note : result.account.notes) {
      if (note.kind == NoteKind::kControl) found.push_back(note.written);
    }
    return found;
  }
  std::size_t lost() const {
    return result.account.counts[static_cast<std::size_t>(Outcome::kLost)];
  }

  test::LoadedRobot robot;
  SdfConversion result;
};

using ControlLines = std::vector<std::string>;

std::string driven_joint(const std::string& name, const ControlLines& interfaces) {
  std::string text = "<joint name='" + name + "'>";
  for (const std::string& one : interfaces) {
    text += "<hardwareInterface>" + one + "</hardwareInterface>";
  }
  return text + "</joint>";
}

std::string transmission(const std::string& joints, const std::string& type = "Simple") {
  return "<transmission name='t'><type>transmission_interface/" + type + "Transmission</type>" +
         joints + "<actuator name='m'/></transmission>";
}

constexpr const char* kPositionInterface = "hardware_interface/PositionJointInterface";
constexpr const char* kVelocityInterface = "hardware_interface/VelocityJointInterface";
constexpr const char* kAllStates =
    "<state_interface name=\"position\"/><state_interface name=\"velocity\"/>"
    "<state_interface name=\"effort\"/></joint>";

TEST(Control, SeveralInterfacesOfAJointAreCommandInterfaces) {
  const std::string blocks =
      transmission(driven_joint("j", {kPositionInterface, kVelocityInterface}));
  const DrivenRobot ros(blocks);
  EXPECT_NE(ros.block().find("<joint name=\"j\"><command_interface name=\"position\"/>"
                             "<command_interface name=\"velocity\"/>" +
                             std::string(kAllStates)),
            std::string::npos)
      << ros.block();
  EXPECT_EQ(ros.losses(), ControlLines{});
  for (const SideFile& file : ros.result.files) {
    if (!file.name.ends_with(".yaml")) continue;
    EXPECT_NE(file.bytes.find("interface_name: velocity\n    joints:\n      - \"j\"\n"),
              std::string::npos)
        << file.bytes;
  }
  // A joint of Gazebo Sim has one controller.
  const DrivenRobot gz(blocks, ControlPolicy::kGz);
  EXPECT_TRUE(gz.has_plugin("JointPositionController"));
  EXPECT_FALSE(gz.has_plugin("JointController"));
  EXPECT_EQ(gz.losses(),
            ControlLines{
                "t loses hardwareInterface hardware_interface/VelocityJointInterface of joint j, "
                "which is not the position command that drives it"});
  EXPECT_EQ(gz.lost(), 1U);
}

TEST(Control, ATransmissionThatDrivesNothingIsLost) {
  const auto lost_by = [](const std::string& joints, ControlPolicy control) {
    const DrivenRobot robot(transmission(joints), control);
    EXPECT_EQ(robot.written(), ControlLines{}) << joints;
    EXPECT_TRUE(robot.result.files.empty()) << joints;
    EXPECT_FALSE(robot.has_plugin("JointStatePublisher")) << joints;
    EXPECT_GE(robot.lost(), 5U);  // each element and attribute
    return robot.losses();
  };
  for (const ControlPolicy control : {ControlPolicy::kRos2Control, ControlPolicy::kGz}) {
    EXPECT_EQ(
        lost_by(driven_joint("j", {"my_pkg/FancyInterface"}), control),
        ControlLines{"t is lost: hardwareInterface my_pkg/FancyInterface of joint j is none of "
                     "position, velocity and effort"});
    EXPECT_EQ(lost_by(driven_joint("j", {}), control),
              ControlLines{"t is lost: joint j has no hardwareInterface"});
    EXPECT_EQ(lost_by(driven_joint("none", {kPositionInterface}), control),
              ControlLines{"t is lost: joint none does not exist"});
    EXPECT_EQ(lost_by(driven_joint("f", {kPositionInterface}), control),
              ControlLines{"t is lost: joint f does not move"});
    EXPECT_EQ(lost_by("", control), ControlLines{"t is lost: it names no joint"});
  }
}

/// The plugin starts the controllers, whatever they drive.
TEST(Control, ThePluginStaysWithoutTransmissions) {
  const DrivenRobot robot(
      transmission(driven_joint("j", {})) +
      "<gazebo><plugin name='c' filename='libgazebo_ros_control.so'/></gazebo>");
  EXPECT_EQ(robot.written(), ControlLines{"plugin libgazebo_ros_control.so"});
  EXPECT_EQ(robot.losses(), ControlLines{"t is lost: joint j has no hardwareInterface"});
  EXPECT_EQ(robot.block().find("<joint"), std::string::npos);
}

TEST(Control, ACouplingOfJointsIsLost) {
  const std::string joints = driven_joint("j", {kPositionInterface}) +
                             driven_joint("k", {kPositionInterface}) +
                             driven_joint("none", {kPositionInterface});
  for (const ControlPolicy control : {ControlPolicy::kRos2Control, ControlPolicy::kGz}) {
    const DrivenRobot robot(transmission(joints, "Differential"), control);
    EXPECT_EQ(robot.written(), ControlLines{"transmission t"});
    EXPECT_EQ(robot.losses(),
              (ControlLines{"t loses what its type does between actuators and joints: "
                            "transmission_interface/DifferentialTransmission",
                            "t loses joint none, which does not exist"}));
    EXPECT_EQ(robot.lost(), 1U + 3U);
  }
  const DrivenRobot attribute(
      "<transmission name='t' type='pr2_mechanism_model/WristTransmission'>" +
      driven_joint("j", {kPositionInterface}) + "</transmission>");
  EXPECT_EQ(attribute.losses(),
            ControlLines{"t loses what its type does between actuators and joints: "
                         "pr2_mechanism_model/WristTransmission"});
  EXPECT_EQ(attribute.lost(), 1U);
}

/// The oldest form has the interface at the actuator; states are those of all joints.
TEST(Control, WhatIsCarriedIsNotReported) {
  const std::string old =
      "<transmission name='t' type='pr2_mechanism_model/SimpleTransmission'><joint name='j'/>"
      "<actuator name='m'><hardwareInterface>EffortJointInterface</hardwareInterface></actuator>"
      "</transmission>";
  const DrivenRobot actuator(old);
  EXPECT_NE(actuator.block().find("<command_interface name=\"effort\"/>"), std::string::npos);
  EXPECT_EQ(actuator.losses(), ControlLines{});
  const DrivenRobot state(
      transmission(driven_joint("j", {"hardware_interface/JointStateInterface"})));
  EXPECT_NE(state.block().find("<joint name=\"j\">" + std::string(kAllStates)), std::string::npos);
  EXPECT_EQ(state.losses(), ControlLines{});
  const DrivenRobot both(
      transmission(driven_joint("j", {"hardware_interface/PosVelJointInterface"})));
  EXPECT_NE(both.block().find("<command_interface name=\"velocity\"/>"), std::string::npos);
  EXPECT_EQ(both.losses(), ControlLines{});
}

/// A block that stays drives its joints; those of transmissions beside it get one of their own.
TEST(Control, TransmissionsBesideABlockOfRos2Control) {
  const std::string kept =
      "<ros2_control name='GazeboSimSystem' type='system'><joint name='j'>"
      "<command_interface name='position'/><command_interface "
      "name='fancy'/></joint></ros2_control>";
  const DrivenRobot ros(kept +
                        transmission(driven_joint("j", {kPositionInterface, kVelocityInterface}) +
                                     driven_joint("k", {kVelocityInterface})));
  EXPECT_NE(ros.block().find("<ros2_control name=\"GazeboSimSystem_2\" type=\"system\">"),
            std::string::npos)
      << ros.block();
  EXPECT_NE(ros.block().find("<joint name=\"k\"><command_interface name=\"velocity\"/>"),
            std::string::npos);
  EXPECT_NE(ros.block().find("<command_interface name='fancy'/>"), std::string::npos);
  EXPECT_EQ(ros.losses(),
            ControlLines{
                "t loses hardwareInterface hardware_interface/VelocityJointInterface of joint j, "
                "which is not in its ros2_control block"});
  const DrivenRobot gz(kept, ControlPolicy::kGz);
  EXPECT_TRUE(gz.has_plugin("JointPositionController"));
  EXPECT_EQ(gz.losses(),
            ControlLines{"GazeboSimSystem loses command_interface fancy of joint j, which is "
                         "none of position, velocity and effort"});
}

}  // namespace
}  // namespace rigor::convert
