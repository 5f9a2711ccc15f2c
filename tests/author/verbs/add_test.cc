// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// add: what is added passes every rule that is on by default.

#include <rigor/author/verbs/add/add.h>

#include <gtest/gtest.h>

#include <rigor/rules/validate.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

/// All that rules say of the text for a target, notes too.
std::string findings_in(VerbBench& bench, const std::string& path, const std::string& text,
                        std::optional<rules::Target> target) {
  Sources sources;
  rules::ValidateOptions options;
  options.buffer = {path, text};
  if (target) options.selection.targets = {*target};
  const rules::ValidateResult result = rules::validate(bench.environment(), options, sources);
  std::string found;
  for (const Diagnostic& each : result.diagnostics.list())
    found += std::string(each.rule) + ": " + each.message + '\n';
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

constexpr const char* kSdfBody = R"(
      <inertial>
        <mass>1</mass>
        <inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia>
      </inertial>
      <collision name="c"><geometry><box><size>0.2 0.2 0.2</size></box></geometry></collision>
    </link>
)";

std::string sensed_sdf(const std::string& version) {
  return "<?xml version=\"1.0\"?>\n<sdf version=\"" + version +
         "\">\n  <model name=\"m\">\n    <link name=\"base\">" + kSdfBody +
         "    <link name=\"head\">\n      <pose>0 0 0.2 0 0 0</pose>" + kSdfBody +
         R"(    <joint name="turn" type="revolute">
      <parent>base</parent>
      <child>head</child>
      <axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper><effort>1</effort><velocity>1</velocity></limit></axis>
    </joint>
  </model>
</sdf>
)";
}

AddRequest add_request(std::string_view what, rules::Target target) {
  AddRequest request;
  request.what = what;
  request.target = target;
  return request;
}

TEST(Add, SensorsPassTheRulesOfTheirTargets) {
  const std::string urdf = "<robot name=\"r\">\n  " + std::string(kSensed) + "</robot>\n";
  std::size_t added_sensors = 0;
  for (const std::string version : {"1.6", "1.7", "1.9"}) {
    VerbBench bench({{"m.sdf", sensed_sdf(version)}, {"r.urdf", urdf}});
    for (const char* path : {"m.sdf", "r.urdf"}) {
      const EditedModel& model = bench.open(path);
      for (const rules::Target target : {rules::Target::kGzSim, rules::Target::kGazeboClassic}) {
        const std::string before =
            findings_in(bench, path, std::string(model.document().bytes()), target);
        for (const std::string_view what :
             {"camera", "depth_camera", "rgbd_camera", "imu", "lidar", "contact", "force_torque",
              "gps", "altimeter", "magnetometer"}) {
          AddRequest request = add_request(what, target);
          request.to = what == "force_torque" ? "turn" : "head";
          request.X = {{0.1, 0, 0}, {}};
          const Change change = added(model, request);
          if (what == "rgbd_camera" && target == rules::Target::kGazeboClassic) {
            EXPECT_EQ(change.refused, "there is no rgbd_camera for the target gazebo-classic");
            continue;
          }
          if (target == rules::Target::kGazeboClassic && version == "1.9" && !model.is_urdf()) {
            EXPECT_EQ(change.refused, "Gazebo classic reads SDF up to 1.7, and the file is 1.9");
            continue;
          }
          const std::string text = bench.text(model, change);
          EXPECT_EQ(findings_in(bench, path, text, target), before) << text;
          const EditedModel& with = bench.open_text(path, text);
          ASSERT_EQ(with.root().sensors.size(), 1U) << what;
          EXPECT_EQ(with.root().sensors[0].pose.pose.value.translation,
                    (model::Vector3{0.1, 0, 0}));
          request.X = {};
          const EditedModel& both = bench.open_text(path, bench.text(with, added(with, request)));
          ASSERT_EQ(both.root().sensors.size(), 2U);
          EXPECT_TRUE(both.root().sensors[1].name.value.ends_with("_2"));
          ++added_sensors;
        }
      }
    }
  }
  EXPECT_EQ(added_sensors, 3U * 2 * (10 + 9) - 9);
}

TEST(Add, WhatASensorNeeds) {
  VerbBench bench({{"m.sdf", sensed_sdf("1.5")}});
  const EditedModel& model = bench.open("m.sdf");
  AddRequest request = add_request("lidar", rules::Target::kGzSim);
  request.to = "head";
  EXPECT_EQ(added(model, request).refused,
            "SDF has lidar since 1.6, and the file is 1.5: upgrade it first");
  request.what = "imu";
  EXPECT_EQ(added(model, request).notes,
            (std::vector<std::string>{"the world has to load gz-sim-imu-system "
                                      "(gz::sim::systems::Imu)"}));
  request.to = "turn";
  EXPECT_EQ(added(model, request).refused, "no link is named 'turn'");
  request.what = "force_torque";
  request.to = "head";
  EXPECT_EQ(added(model, request).refused, "no joint is named 'head'");
}

/// A body on wheels of 0.1 m: at x = 0.2 and x = -0.2, 0.5 m apart, and a caster.
std::string wheeled_urdf(const std::string& front) {
  const auto link = [](const std::string& name, const std::string& shape) {
    return "<link name=\"" + name + R"(">
    <inertial>
      <mass value="2"/>
      <inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/>
    </inertial>
    <collision>)" +
           shape + "</collision>\n  </link>\n  ";
  };
  const std::string wheel =
      R"(<origin rpy="1.5707963267948966 0 0"/><geometry><cylinder radius="0.1" length="0.05"/></geometry>)";
  const auto joint = [](const std::string& name, const std::string& type, const std::string& parent,
                        const std::string& child, const std::string& xyz, const std::string& axis) {
    return "<joint name=\"" + name + "\" type=\"" + type + "\">\n    <origin xyz=\"" + xyz +
           "\"/>\n    <parent link=\"" + parent + "\"/>\n    <child link=\"" + child +
           "\"/>\n    <axis xyz=\"" + axis +
           "\"/>\n    <limit effort=\"5\" velocity=\"10\" lower=\"-0.6\" upper=\"0.6\"/>\n  "
           "</joint>\n  ";
  };
  std::string text =
      "<robot name=\"car\">\n  " + link("base", "<geometry><box size=\"0.5 0.3 0.1\"/></geometry>");
  for (const std::string side : {"left", "right"}) {
    const std::string y = side == "left" ? "0.25" : "-0.25";
    text += link("rear_" + side, wheel) +
            joint("rear_" + side + "_joint", "continuous", "base", "rear_" + side,
                  "-0.2 " + y + " 0", "0 1 0") +
            link("front_" + side, wheel);
    if (front == "steered" || front == "caster") {
      const std::string type = front == "steered" ? "revolute" : "continuous";
      const std::string pin = side == "left" ? "0.2" : "-0.2";
      text += link("pin_" + side, "<geometry><box size=\"0.02 0.02 0.02\"/></geometry>") +
              joint("pin_" + side + "_joint", type, "base", "pin_" + side, "0.2 " + pin + " 0",
                    "0 0 1") +
              joint("front_" + side + "_joint", "continuous", "pin_" + side, "front_" + side,
                    std::string("0 ") + (side == "left" ? "0.05" : "-0.05") + " 0", "0 1 0");
    } else {
      text += joint("front_" + side + "_joint", "continuous", "base", "front_" + side,
                    "0.2 " + y + " 0", "0 1 0");
    }
  }
  return text + "</robot>\n";
}

std::string parameter(const std::string& text, const std::string& name) {
  std::string all;
  const std::string tag = '<' + name + '>';
  for (std::size_t at = 0; (at = text.find(tag, at)) != std::string::npos; ++at) {
    const std::size_t begin = at + tag.size();
    all += (all.empty() ? "" : " ") + text.substr(begin, text.find('<', begin) - begin);
  }
  return all;
}

TEST(Add, ADriveKnowsItsWheels) {
  for (const rules::Target target : {rules::Target::kGzSim, rules::Target::kGazeboClassic}) {
    for (const std::string front : {"caster", "fixed"}) {
      VerbBench bench({{"car.urdf", wheeled_urdf(front)}});
      const EditedModel& car = bench.open("car.urdf");
      const std::string text = bench.text(car, added(car, add_request("diff-drive", target)));
      const bool both = front == "fixed";
      const bool is_new = target == rules::Target::kGzSim;
      EXPECT_EQ(parameter(text, "left_joint"),
                both ? "front_left_joint rear_left_joint" : "rear_left_joint");
      EXPECT_EQ(parameter(text, "right_joint"),
                both ? "front_right_joint rear_right_joint" : "rear_right_joint");
      EXPECT_EQ(parameter(text, "wheel_separation"), both && !is_new ? "0.5 0.5" : "0.5");
      if (is_new) {
        EXPECT_EQ(parameter(text, "wheel_radius"), "0.1");
      } else {
        EXPECT_EQ(parameter(text, "wheel_diameter"), both ? "0.2 0.2" : "0.2");
      }
      EXPECT_EQ(findings_in(bench, "car.urdf", text, target),
                findings_in(bench, "car.urdf", wheeled_urdf(front), target))
          << text;
    }
  }
}

TEST(Add, AckermannSteering) {
  VerbBench bench({{"car.urdf", wheeled_urdf("steered")}, {"skid.urdf", wheeled_urdf("fixed")}});
  const EditedModel& car = bench.open("car.urdf");
  const AddRequest request = add_request("ackermann", rules::Target::kGzSim);
  const std::string text = bench.text(car, added(car, request));
  EXPECT_EQ(parameter(text, "left_joint"), "rear_left_joint");
  EXPECT_EQ(parameter(text, "left_steering_joint"), "pin_left_joint");
  EXPECT_EQ(parameter(text, "right_steering_joint"), "pin_right_joint");
  EXPECT_EQ(parameter(text, "kingpin_width"), "0.4");
  EXPECT_EQ(parameter(text, "wheel_base"), "0.4");
  EXPECT_EQ(parameter(text, "wheel_separation"), "0.5");
  EXPECT_EQ(parameter(text, "steering_limit"), "0.6");
  EXPECT_EQ(findings_in(bench, "car.urdf", text, request.target),
            findings_in(bench, "car.urdf", wheeled_urdf("steered"), request.target));
  EXPECT_EQ(added(bench.open("skid.urdf"), request).refused,
            "no pair of wheels is steered: each behind a revolute joint of its own about z");
}

TEST(Add, PluginsPassTheRulesOfTheirTargets) {
  struct Case {
    const char* what;
    rules::Target target;
  };
  VerbBench bench({{"car.urdf", wheeled_urdf("steered")}, {"m.sdf", sensed_sdf("1.7")}});
  for (const char* path : {"car.urdf", "m.sdf"}) {
    const EditedModel& model = bench.open(path);
    const std::string source(model.document().bytes());
    for (const auto& [what, target] : {Case{"joint-state-publisher", rules::Target::kGzSim},
                                       Case{"joint-position-controller", rules::Target::kGzSim},
                                       Case{"odometry-publisher", rules::Target::kGzSim},
                                       Case{"pose-publisher", rules::Target::kGzSim},
                                       Case{"joint-state-publisher", rules::Target::kGazeboClassic},
                                       Case{"odometry-publisher", rules::Target::kGazeboClassic}}) {
      const std::string text = bench.text(model, added(model, add_request(what, target)));
      EXPECT_NE(text, source);
      EXPECT_EQ(findings_in(bench, path, text, target), findings_in(bench, path, source, target))
          << text;
    }
  }
  AddRequest one = add_request("joint-position-controller", rules::Target::kGzSim);
  one.to = "pin_left_joint";
  const EditedModel& car = bench.open("car.urdf");
  const std::string text = bench.text(car, added(car, one));
  EXPECT_EQ(parameter(text, "joint_name"), "pin_left_joint");
  EXPECT_EQ(parameter(text, "cmd_max"), "10");
  EXPECT_EQ(parameter(text, "cmd_min"), "-10");
  const EditedModel& still = bench.open("m.sdf");
  EXPECT_EQ(added(still, add_request("diff-drive", rules::Target::kGzSim)).refused,
            "no pair of wheels is found: continuous joints about y whose links have round shapes");
}

TEST(Add, Ros2ControlInASimulator) {
  const std::string urdf = "<robot name=\"r\">\n  " + std::string(kSensed) + "</robot>\n";
  VerbBench bench({{"r.urdf", urdf}, {"config/controllers.yaml", "controller_manager: {}\n"}});
  const EditedModel& robot = bench.open("r.urdf");
  for (const rules::Target target : {rules::Target::kGzSim, rules::Target::kGazeboClassic}) {
    AddRequest request = add_request("ros2_control", target);
    EXPECT_EQ(added(robot, request).refused,
              "the plugin needs the controllers' YAML: name it with --parameters");
    request.parameters = "config/controllers.yaml";
    const std::string text = bench.text(robot, added(robot, request));
    EXPECT_EQ(parameter(text, "parameters"), "config/controllers.yaml");
    EXPECT_EQ(findings_in(bench, "r.urdf", text, target),
              findings_in(bench, "r.urdf", urdf, target))
        << text;
  }
}

TEST(Add, TransmissionsOfJointsThatHaveNone) {
  const std::string urdf = "<robot name=\"r\">\n  " + std::string(kSensed) + "</robot>\n";
  VerbBench bench({{"r.urdf", urdf}});
  const EditedModel& robot = bench.open("r.urdf");
  const AddRequest request = add_request("transmission", rules::Target::kRos);
  const std::string text = bench.text(robot, added(robot, request));
  EXPECT_EQ(text, urdf.substr(0, urdf.find("</robot>")) +
                      R"(  <transmission name="turn_transmission">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="turn">
      <hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface>
    </joint>
    <actuator name="turn_motor">
      <hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface>
      <mechanicalReduction>1</mechanicalReduction>
    </actuator>
  </transmission>
</robot>
)");
  EXPECT_EQ(findings_in(bench, "r.urdf", text, request.target),
            findings_in(bench, "r.urdf", urdf, request.target));
  EXPECT_EQ(added(bench.open_text("r.urdf", text), request).refused,
            "the joints have transmissions already");
}

TEST(Add, HardwareForAllJointsThatMove) {
  const std::string urdf = "<robot name=\"r\">\n  " + std::string(kSensed) + "</robot>\n";
  VerbBench bench({{"r.urdf", urdf}});
  const EditedModel& robot = bench.open("r.urdf");
  const std::string text =
      bench.text(robot, added(robot, add_request("ros2_control", rules::Target::kRos)));
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
  EXPECT_EQ(findings_in(bench, "r.urdf", text, {}), findings_in(bench, "r.urdf", urdf, {}));
  const EditedModel& controlled = bench.open_text("r.urdf", text);
  EXPECT_EQ(added(controlled, add_request("ros2_control", rules::Target::kRos)).refused,
            "it has a <ros2_control> already");
}

}  // namespace
}  // namespace rigor::author
