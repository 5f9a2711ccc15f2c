// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor urdf2sdf --control`: transmissions and plugins that drive joints.

#include <gtest/gtest.h>

#include <string>

#include "cli/conversion_models.h"

namespace rigor::test {
namespace {

TEST_F(ConversionCli, TransmissionsBecomeWhatIsChosen) {
  folder.put(
      "r.urdf",
      "<robot name='r'>" + urdf_link("a") + urdf_link("b") +
          urdf_joint("j", "revolute", "a", "b",
                     "<axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='5' velocity='2'/>") +
          "<transmission name='t'><type>transmission_interface/SimpleTransmission</type>"
          "<joint name='j'><hardwareInterface>hardware_interface/PositionJointInterface"
          "</hardwareInterface></joint><actuator name='m'/></transmission>"
          "<gazebo><plugin name='c' filename='libgazebo_ros_control.so'/></gazebo></robot>");
  EXPECT_NE(folder.rigor("urdf2sdf r.urdf").out.find("libgazebo_ros_control.so"),
            std::string::npos);
  const Ran gz = folder.rigor("urdf2sdf r.urdf --control gz");
  EXPECT_EQ(gz.exit, 0) << gz.err;
  EXPECT_EQ(gz.out.find("libgazebo_ros_control.so"), std::string::npos);
  EXPECT_NE(gz.out.find("gz::sim::systems::JointPositionController"), std::string::npos) << gz.out;
  EXPECT_NE(gz.out.find("<joint_name>j</joint_name>"), std::string::npos);
  folder.put("out/.keep", "");
  const Ran ros = folder.rigor("urdf2sdf r.urdf --control ros2_control -o out/r.sdf");
  EXPECT_EQ(ros.exit, 0) << ros.err;
  EXPECT_NE(folder.get("out/r.ros2_control.xacro").find("<command_interface name=\"position\"/>"),
            std::string::npos);
  EXPECT_NE(folder.get("out/r.controllers.yaml").find("- \"j\""), std::string::npos);
  EXPECT_NE(folder.get("out/r.sdf").find("<parameters>r.controllers.yaml</parameters>"),
            std::string::npos);
}

/// What lies beside a result that is new there is somebody else's.
TEST_F(ConversionCli, NoFileOfSomebodyElseIsReplaced) {
  folder.put("m.sdf",
             "<sdf version='1.9'><model name='m'><link name='l'><visual name='v'><geometry>"
             "<ellipsoid><radii>1 0.5 0.5</radii></ellipsoid></geometry></visual></link></model>"
             "</sdf>");
  const std::string name = "ellipsoid-1x0.5x0.5.stl";
  folder.put("second/" + name, "mine");
  const Ran refused = folder.rigor("sdf2urdf m.sdf -o second/m.urdf");
  EXPECT_EQ(refused.exit, 2);
  EXPECT_NE(refused.err.find(name + " exists and is another file"), std::string::npos)
      << refused.err;
  EXPECT_EQ(folder.get("second/" + name), "mine");
  EXPECT_FALSE(exists("second/m.urdf"));
  // A result that was there goes with what lies beside it.
  folder.put("first/" + name, "old");
  folder.put("first/m.urdf", "old");
  EXPECT_EQ(folder.rigor("sdf2urdf m.sdf -o first/m.urdf").exit, 0);
  EXPECT_NE(folder.get("first/" + name), "old");
}

/// The parameters of gz-sim 8's DiffDrive, by its documentation: topic, odom_topic, frame_id,
/// child_frame_id and odom_publish_frequency; it has none for the torque of a wheel.
TEST_F(ConversionCli, DrivePluginsOfGazeboClassicBecomeDiffDrive) {
  const std::string wheel = "<axis xyz='0 1 0'/>";
  folder.put("r.urdf",
             "<robot name='r'>" + urdf_link("base") + urdf_link("left") + urdf_link("right") +
                 urdf_joint("left_wheel", "continuous", "base", "left", wheel) +
                 urdf_joint("right_wheel", "continuous", "base", "right", wheel) +
                 "<transmission name='t'><joint name='left_wheel'><hardwareInterface>"
                 "hardware_interface/VelocityJointInterface</hardwareInterface></joint>"
                 "<actuator name='m'><mechanicalReduction>30</mechanicalReduction></actuator>"
                 "</transmission>"
                 "<gazebo><plugin name='d' filename='libgazebo_ros_diff_drive.so'>"
                 "<leftJoint>left_wheel</leftJoint><rightJoint>right_wheel</rightJoint>"
                 "<wheelSeparation>0.5</wheelSeparation><wheelDiameter>0.3</wheelDiameter>"
                 "<commandTopic>cmd_vel</commandTopic><odometryFrame>odom</odometryFrame>"
                 "<wheelTorque>20</wheelTorque></plugin></gazebo></robot>");
  const Ran ran = folder.rigor("urdf2sdf r.urdf --control gz -o r.sdf");
  EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
  const std::string sdf = folder.get("r.sdf");
  for (const std::string line :
       {"name=\"gz::sim::systems::DiffDrive\"", "<left_joint>left_wheel</left_joint>",
        "<right_joint>right_wheel</right_joint>", "<wheel_separation>0.5</wheel_separation>",
        "<wheel_radius>0.15</wheel_radius>", "<topic>cmd_vel</topic>",
        "<frame_id>odom</frame_id>"}) {
    EXPECT_NE(sdf.find(line), std::string::npos) << line << "\n" << sdf;
  }
  EXPECT_EQ(sdf.find("JointController"), std::string::npos) << "the drive has the joint already";
  EXPECT_NE(ran.out.find("plugin/wheelTorque is not in the result"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("a mechanicalReduction of 30 is not in the result"), std::string::npos);
}

TEST_F(ConversionCli, ThePublisherOfJointStatesIsWrittenWhereItIsAlone) {
  folder.put("r.urdf",
             "<robot name='r'>" + urdf_link("a") +
                 "<gazebo><plugin name='p' filename='libgazebo_ros_joint_state_publisher.so'>"
                 "<jointName>a</jointName><updateRate>5</updateRate></plugin></gazebo></robot>");
  const Ran ran = folder.rigor("urdf2sdf r.urdf --control gz");
  EXPECT_NE(ran.out.find("gz::sim::systems::JointStatePublisher"), std::string::npos) << ran.out;
  EXPECT_NE(ran.err.find("plugin/updateRate is not in the result"), std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.find("plugin/jointName"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace rigor::test
