// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Frames of SDF that are what is left of a URDF's fixed joints: from SDF to URDF, and there and back.

#include <rigor/convert/urdf_to_sdf.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "convert/converted.h"
#include "convert/loaded_robot.h"

namespace rigor::convert {
namespace {

using test::Converted;
using test::digits_of;
using test::sdf_joint;
using test::sdf_link;

using LinkNames = std::vector<std::string>;

/// "cam_mount: base → cam", in the order of the alphabet.
std::vector<std::string> edges_of(const UrdfRobot& robot) {
  std::vector<std::string> edges;
  for (const UrdfJoint& joint : robot.joints) {
    edges.push_back(joint.name + ": " + joint.parent + " → " + joint.child);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<std::string> edges_there_and_back(const std::string& urdf) {
  const test::LoadedRobot there(urdf);
  const Converted back({{"robot.sdf", sdf_text(*urdf_to_sdf(there.source(), {}).robot)}});
  return edges_of(back.result.robot.value());
}

std::string urdf_mass(const std::string& name) {
  return "<link name='" + name +
         "'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
         "izz='1'/></inertial></link>";
}

std::string urdf_edge(const std::string& name, const std::string& type, const std::string& parent,
                      const std::string& child, const std::string& origin = "0 0 0") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/><origin xyz='" + origin + "'/></joint>";
}

TEST(JointFrame, OneNextToTheFrameOnItIsItsJoint) {
  const Converted robot(
      sdf_link("base") +
      "<frame name='cam_mount' attached_to='base'><pose>0 1 0 0 0 0</pose></frame>"
      "<frame name='cam' attached_to='cam_mount'/>"
      "<frame name='cam_to_tool0' attached_to='cam'/>"
      "<frame name='tool0' attached_to='cam_to_tool0'/>"
      "<link name='arm'><pose relative_to='turn'/><inertial><mass>1</mass></inertial></link>" +
      sdf_joint("turn", "revolute", "tool0", "arm",
                "<pose relative_to='tool0'>0 0 0.5 0 0 0</pose><axis><xyz>0 0 1</xyz></axis>"));
  EXPECT_EQ(robot.link_names(), (LinkNames{"base", "arm", "cam", "tool0"}));
  EXPECT_EQ(edges_of(*robot.result.robot),
            (std::vector<std::string>{"cam_mount: base → cam", "cam_to_tool0: cam → tool0",
                                      "turn: base → arm"}))
      << "libsdformat drops what hangs on a link without mass";
  EXPECT_EQ(digits_of(robot.joint("cam_mount").origin.xyz), "0 1 0");
  EXPECT_EQ(digits_of(robot.joint("turn").origin.xyz), "0 1 0.5");
}

/// Only what a conversion writes is taken for a joint.
TEST(JointFrame, OtherFramesAreLinks) {
  const std::string base = sdf_link("base") + sdf_link("arm", "1 0 0 0 0 0");
  const auto links = [&](const std::string& frames, const std::string& parent = "base") {
    return Converted(base + frames + sdf_joint("j", "fixed", parent, "arm")).link_names();
  };
  const std::string mount = "<frame name='mount' attached_to='base'/>";
  const std::string cam = "<frame name='cam' attached_to='mount'/>";
  EXPECT_EQ(links(mount + cam), (LinkNames{"base", "arm", "cam"}));
  EXPECT_EQ(links(mount + "<frame name='lamp' attached_to='base'/>" + cam),
            (LinkNames{"base", "arm", "mount", "lamp", "cam"}))
      << "apart";
  EXPECT_EQ(links(mount + cam, "mount"), (LinkNames{"base", "arm", "mount", "cam"}))
      << "named by a joint";
  EXPECT_EQ(links(mount + cam + "<frame name='lamp'><pose relative_to='mount'/></frame>"),
            (LinkNames{"base", "arm", "mount", "cam", "lamp"}))
      << "a place for another";
  EXPECT_EQ(links("<frame name='cam_link' attached_to='base'/><frame name='cam' "
                  "attached_to='cam_link'/>"),
            (LinkNames{"base", "arm", "cam_link", "cam"}))
      << "called a link";
}

TEST(JointFrame, FixedJointsKeepNamesAndParentsThereAndBack) {
  const std::string urdf =
      "<robot name='r'>" + urdf_mass("base") + urdf_mass("arm") +
      "<link name='tip'/><link name='cam'/><link name='cam_optical_frame'/><link name='tool0'/>" +
      urdf_edge("base_link_to_tip", "fixed", "base", "tip") +
      urdf_edge("cam_mount", "fixed", "tip", "cam", "0 1 0") +
      urdf_edge("cam_optical", "fixed", "cam", "cam_optical_frame") +
      urdf_edge("flange-tool0", "fixed", "cam", "tool0") +
      urdf_edge("turn", "continuous", "base", "arm") + "</robot>";
  EXPECT_EQ(edges_there_and_back(urdf),
            (std::vector<std::string>{"base_link_to_tip: base → tip", "cam_mount: tip → cam",
                                      "cam_optical: cam → cam_optical_frame",
                                      "flange-tool0: cam → tool0", "turn: base → arm"}));
}

/// Whatever a joint is called: frames of links are no joints.
TEST(JointFrame, JointsAndLinksAlternate) {
  const std::string urdf = "<robot name='r'>" + urdf_mass("base") +
                           "<link name='tip'/><link name='cam'/>" +
                           urdf_edge("tip_link", "fixed", "base", "tip") +
                           urdf_edge("cam_mount", "fixed", "tip", "cam") + "</robot>";
  const std::vector<std::string> edges = edges_there_and_back(urdf);
  EXPECT_NE(std::find(edges.begin(), edges.end(), "cam_mount: tip → cam"), edges.end())
      << testing::PrintToString(edges);
}

TEST(JointFrame, TheJointOfAFootprintKeepsItsName) {
  const std::string urdf =
      "<robot name='r'><link name='base_footprint'/>" + urdf_mass("base") + "<link name='imu'/>" +
      urdf_edge("imu_mount", "fixed", "base_footprint", "imu") +
      urdf_edge("footprint_to_base", "fixed", "base_footprint", "base", "0 0 0.1") + "</robot>";
  const std::vector<std::string> edges = edges_there_and_back(urdf);
  EXPECT_NE(std::find(edges.begin(), edges.end(), "footprint_to_base: base_footprint → base"),
            edges.end())
      << testing::PrintToString(edges);
}

}  // namespace
}  // namespace rigor::convert
