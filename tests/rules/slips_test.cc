// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules on slips that only the whole robot shows: where they begin to speak and how loudly, against numbers
// worked out by hand.

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {
namespace {

using SlipSeverities = std::vector<Severity>;

const SlipSeverities kSlipWarning{Severity::kWarning};
const SlipSeverities kSlipInfo{Severity::kInfo};

/// Of one rule in one file, beside the model of a table.
SlipSeverities found(const std::string& rule, const std::string& path, const std::string& text) {
  const MemoryDisk disk(std::map<std::string, std::string>{
      {path, text},
      {"table/model.config", "<model><name>table</name><sdf>model.sdf</sdf></model>"},
      {"table/model.sdf",
       "<sdf version='1.9'><model name='table'><link name='top'/></model></sdf>"}});
  const Environment environment(disk, {});
  Sources sources;
  SlipSeverities severities;
  const ValidateResult result = validate(environment, {.paths = {path}}, sources);
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    if (diagnostic.rule == rule) severities.push_back(diagnostic.severity);
  }
  return severities;
}

/// 2 kg half a meter from a joint: 2 · 0.5 · 9.8 = 9.8 N·m when its axis is level, 19.6 N along a slider.
std::string pendulum(const std::string& type, const std::string& axis, const std::string& effort,
                     const std::string& inside = "",
                     const std::string& limits = "lower='-1' upper='1'") {
  return "<robot name='r'><link name='a'/><link name='b'><inertial><origin xyz='0.5 0 0'/><mass "
         "value='2'/>"
         "<inertia ixx='0.1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1'/></inertial></link>"
         "<joint name='j' type='" +
         type + "'><parent link='a'/><child link='b'/><axis xyz='" + axis + "'/><limit " + limits +
         " velocity='3' effort='" + effort + "'/>" + inside + "</joint></robot>";
}

TEST(Slips, EffortIsComparedWithTheTorqueOfTheWeight) {
  const std::string rule = "effort-below-gravity-load";
  EXPECT_EQ(found(rule, "a.urdf", pendulum("revolute", "0 1 0", "9.9")), SlipSeverities{});
  EXPECT_EQ(found(rule, "a.urdf", pendulum("revolute", "0 1 0", "9.7")), kSlipInfo);
  EXPECT_EQ(found(rule, "a.urdf", pendulum("revolute", "0 1 0", "2.9")), kSlipWarning);
  // About the vertical nothing pulls, and at 30° from it half as much.
  EXPECT_EQ(found(rule, "a.urdf", pendulum("revolute", "0 0 1", "0.1")), SlipSeverities{});
  EXPECT_EQ(found(rule, "a.urdf", pendulum("revolute", "0 0.5 0.8660254", "5")), SlipSeverities{});
  EXPECT_EQ(found(rule, "a.urdf", pendulum("revolute", "0 0.5 0.8660254", "4.8")), kSlipInfo);
  EXPECT_EQ(found(rule, "a.urdf", pendulum("prismatic", "0 0 1", "19.7")), SlipSeverities{});
  EXPECT_EQ(found(rule, "a.urdf", pendulum("prismatic", "0 0 1", "5.8")), kSlipWarning);
}

TEST(Slips, EffortIsComparedBetweenTheLimits) {
  const std::string rule = "effort-below-gravity-load";
  const auto between = [&](const std::string& limits, const std::string& effort) {
    return found(rule, "a.urdf", pendulum("revolute", "0 1 0", effort, "", limits));
  };
  // Level at zero: 60° below it half of 9.8 N·m is left, at 45° 0.707 of it.
  EXPECT_EQ(between("lower='1.04719755' upper='1.5'", "5"), SlipSeverities{});
  EXPECT_EQ(between("lower='1.04719755' upper='1.5'", "4.8"), kSlipInfo);
  EXPECT_EQ(between("lower='-1.5' upper='-0.78539816'", "7"), SlipSeverities{});
  EXPECT_EQ(between("lower='-1.5' upper='-0.78539816'", "6.8"), kSlipInfo);
  // Level again half a turn further on.
  EXPECT_EQ(between("lower='1.6' upper='3.2'", "9.7"), kSlipInfo);
  // Where the limits are equal, the stops hold it.
  EXPECT_EQ(between("lower='0' upper='0'", "0.1"), SlipSeverities{});
}

TEST(Slips, DampingIsComparedWithWhatTheEffortReaches) {
  const std::string rule = "dynamics-exceed-effort";
  const auto damped = [](const std::string& dynamics) {
    return pendulum("revolute", "0 1 0", "50", "<dynamics " + dynamics + "/>");
  };
  EXPECT_EQ(found(rule, "a.urdf", damped("damping='1600'")),
            SlipSeverities{});  // 50 / 1600 > 1 % of 3 rad/s
  EXPECT_EQ(found(rule, "a.urdf", damped("damping='1700'")), kSlipWarning);
  EXPECT_EQ(found(rule, "a.urdf", damped("friction='49'")), SlipSeverities{});
  EXPECT_EQ(found(rule, "a.urdf", damped("friction='51'")), kSlipWarning);
}

/// Wheels of 0.1 m, 0.5 m apart, at ±y, that turn about their y.
std::string rover(const std::string& separation, const std::string& radius,
                  const std::string& right_axis = "0 1 0") {
  const auto wheel = [](const std::string& name, const std::string& y, const std::string& axis) {
    return "<link name='" + name + "'><pose>0 " + y + " 0.1 0 0 0</pose><collision name='c'>" +
           "<pose>0 0 0 1.5707963 0 "
           "0</pose><geometry><cylinder><radius>0.1</radius><length>0.05</length>"
           "</cylinder></geometry></collision></link><joint name='" +
           name + "_axle' type='revolute'><parent>base</parent><child>" + name +
           "</child><axis><xyz>" + axis + "</xyz></axis></joint>";
  };
  return "<sdf version='1.9'><model name='m'><link name='base'/>" + wheel("l", "0.25", "0 1 0") +
         wheel("r", "-0.25", right_axis) +
         "<plugin filename='gz-sim-diff-drive-system' name='gz::sim::systems::DiffDrive'>"
         "<left_joint>l_axle</left_joint><right_joint>r_axle</right_joint><wheel_separation>" +
         separation + "</wheel_separation><wheel_radius>" + radius +
         "</wheel_radius></plugin></model></sdf>";
}

TEST(Slips, DrivesAreComparedWithTheirWheels) {
  EXPECT_EQ(found("wheel-separation-mismatch", "a.sdf", rover("0.5", "0.1")), SlipSeverities{});
  // Half of the tread's 0.05 m is 5 %: the point of contact is within it.
  EXPECT_EQ(found("wheel-separation-mismatch", "a.sdf", rover("0.52", "0.1")), SlipSeverities{});
  EXPECT_EQ(found("wheel-separation-mismatch", "a.sdf", rover("0.48", "0.1")), SlipSeverities{});
  EXPECT_EQ(found("wheel-separation-mismatch", "a.sdf", rover("0.53", "0.1")), kSlipWarning);
  EXPECT_EQ(found("wheel-separation-mismatch", "a.sdf", rover("0.25", "0.1")), kSlipWarning);
  EXPECT_EQ(found("wheel-separation-mismatch", "a.sdf", rover("1", "0.1")), kSlipWarning);
  EXPECT_EQ(found("wheel-radius-mismatch", "a.sdf", rover("0.5", "0.095")), SlipSeverities{});
  EXPECT_EQ(found("wheel-radius-mismatch", "a.sdf", rover("0.5", "0.2")), kSlipWarning);
  EXPECT_EQ(found("drive-wheels-inconsistent", "a.sdf", rover("0.5", "0.1")), SlipSeverities{});
  EXPECT_EQ(found("drive-wheels-inconsistent", "a.sdf", rover("0.5", "0.1", "0 -1 0")),
            kSlipWarning);
}

TEST(Slips, ANoiseOfAllAxesIsRead) {
  const auto imu = [](const std::string& rate) {
    return "<sdf version='1.4'><model name='m'><link name='base'><sensor name='s' type='imu'><imu>"
           "<noise><type>gaussian</type><rate><mean>0</mean><stddev>" +
           rate +
           "</stddev></rate><accel><mean>0</mean><stddev>0.017</stddev></accel></noise></imu>"
           "</sensor></link></model></sdf>";
  };
  EXPECT_EQ(found("noise-too-large", "a.sdf", imu("0.0002")), SlipSeverities{});
  EXPECT_EQ(found("noise-too-large", "a.sdf", imu("0.2")), kSlipWarning);
  EXPECT_EQ(found("noise-stddev-negative", "a.sdf", imu("0.0002")), SlipSeverities{});
  EXPECT_EQ(found("noise-stddev-negative", "a.sdf", imu("-0.0002")), kSlipWarning);
}

TEST(Slips, ASpringIsComparedWithTheWeight) {
  // 2 kg: 19.6 N, which 1e-5 m holds at 1.96e6 N/m.
  const auto sprung = [](const std::string& stiffness) {
    return "<sdf version='1.9'><model name='m'><link "
           "name='base'><inertial><mass>1</mass></inertial></link>"
           "<link name='foot'><inertial><mass>1</mass></inertial></link><joint name='j' "
           "type='prismatic'>"
           "<parent>base</parent><child>foot</child><axis><xyz>0 0 "
           "1</xyz><dynamics><spring_stiffness>" +
           stiffness + "</spring_stiffness></dynamics></axis></joint></model></sdf>";
  };
  EXPECT_EQ(found("spring-too-stiff", "a.sdf", sprung("1.9e6")), SlipSeverities{});
  EXPECT_EQ(found("spring-too-stiff", "a.sdf", sprung("2.0e6")), kSlipWarning);
}

TEST(Slips, RatesOfZeroAreGradedByWhatTheyCost) {
  const auto sensor = [](const std::string& type) {
    return "<sdf version='1.9'><model name='m'><link name='l'><sensor name='s' type='" + type +
           "'><update_rate>0</update_rate></sensor></link></model></sdf>";
  };
  EXPECT_EQ(found("update-rate-zero", "a.sdf", sensor("imu")), kSlipInfo);
  EXPECT_EQ(found("update-rate-zero", "a.sdf", sensor("camera")), kSlipWarning);
}

TEST(Slips, IncludesWithoutSchemeAreGradedByTheOthers) {
  const auto world = [](const std::string& first) {
    return "<sdf version='1.9'><world name='w'><include><uri>" + first +
           "</uri></include><include><uri>table</uri></include></world></sdf>";
  };
  EXPECT_EQ(found("include-uri-without-scheme", "a.sdf", world("model://sun")), kSlipWarning);
  EXPECT_EQ(found("include-uri-without-scheme", "a.sdf", world("models/sun")), kSlipInfo);
  // What is not found is one finding, of another rule.
  EXPECT_EQ(
      found("include-uri-without-scheme", "a.sdf",
            "<sdf version='1.9'><world name='w'><include><uri>chair</uri></include></world></sdf>"),
      SlipSeverities{});
}

TEST(Slips, LockedJointsAreGradedByWhetherTheyHaveAMotor) {
  const auto joint = [](const std::string& type, const std::string& limit) {
    return "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='" + type +
           "'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/><limit " + limit +
           "/></joint></robot>";
  };
  const std::string motor = "effort='40' velocity='3'";
  EXPECT_EQ(found("limit-equal", "a.urdf", joint("revolute", "lower='0' upper='0' " + motor)),
            kSlipWarning);
  EXPECT_EQ(found("limit-equal", "a.urdf",
                  joint("revolute", "lower='0' upper='0' effort='1' velocity='1'")),
            kSlipInfo);
}

TEST(Slips, FramesAreGradedByHowNearTheyAre) {
  const auto robot = [](const std::string& frame) {
    return "<robot name='r'><link name='laser_link'/><gazebo reference='laser_link'><sensor "
           "name='s' type='imu'>"
           "<gz_frame_id>" +
           frame + "</gz_frame_id></sensor></gazebo></robot>";
  };
  EXPECT_EQ(found("sensor-frame-missing", "a.urdf", robot("laser_lnik")), kSlipWarning);
  EXPECT_EQ(found("sensor-frame-missing", "a.urdf", robot("scan_frame")), kSlipInfo);
  EXPECT_EQ(found("sensor-frame-missing", "a.urdf", robot("laser_link")), SlipSeverities{});
}

/// A robot whose first link hangs on one that stands for the place of the robot, as PR2 is written.
std::string placed_by(const std::string& root) {
  const std::string body =
      "<visual><geometry><box size='0.6 0.4 0.2'/></geometry></visual><collision><geometry><box "
      "size='0.6 0.4 0.2'/></geometry></collision>";
  return "<robot name='r'><link name='chassis'>" + body + "</link><link name='" + root +
         "'><visual><geometry><box size='0.01 0.01 0.01'/></geometry></visual><collision><origin "
         "xyz='0 0 0.07'/><geometry><box size='0.001 0.001 0.001'/></geometry></collision></link>"
         "<link name='mast'>" +
         body + "</link><joint name='j' type='fixed'><child link='chassis'/><parent link='" + root +
         "'/></joint><joint name='k' type='fixed'><origin xyz='0 0 0.2'/><parent "
         "link='chassis'/><child link='mast'/></joint></robot>";
}

TEST(Slips, ARobotMayHangOnItsFootprint) {
  EXPECT_EQ(found("joint-ends-swapped", "a.urdf", placed_by("base_footprint")), SlipSeverities{});
  EXPECT_EQ(found("joint-ends-swapped", "a.urdf", placed_by("wheel")), kSlipWarning);
  EXPECT_EQ(found("collision-beside-visual", "a.urdf", placed_by("base_footprint")),
            SlipSeverities{});
}

}  // namespace
}  // namespace rigor::rules
