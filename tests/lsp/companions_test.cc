// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lsp/editor.h"

namespace rigor::lsp {
namespace {

using test::Editor;

constexpr const char* kSrdfRobot =
    "<robot name='arm'><link name='base'/><link name='hand'/><joint name='wrist' type='revolute'>"
    "<parent link='base'/><child link='hand'/><axis xyz='0 0 1'/>"
    "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>";

std::vector<std::string> messages(Editor& editor, const std::string& path) {
  std::vector<std::string> list;
  for (const Json& each : editor.diagnostics(path)) list.push_back(text_at(each, "message"));
  return list;
}

TEST(LspCompanions, AnSrdfIsHeldAgainstItsRobot) {
  MemoryDisk disk(test::Files{{"/ws/arm.urdf", kSrdfRobot}});
  Editor editor(disk);
  editor.open("/ws/arm.srdf",
              "<robot name='arm'>\n"
              "<virtual_joint name='fixed' type='fixed' parent_frame='world' child_link='base'/>\n"
              "<group name='g'><joint name='wrist'/><joint name='fixed'/><link name='palm'/>"
              "</group>\n"
              "<group_state name='up' group='g'><joint name='wrist' value='1.5'/></group_state>\n"
              "<group_state name='ok' group='g'><joint name='wrist' value='1.00001'/>"
              "</group_state>\n"
              "<end_effector name='e' parent_link='hand' group='gripper'/>\n"
              "</robot>\n");
  EXPECT_EQ(messages(editor, "/ws/arm.srdf"),
            (std::vector<std::string>{"link 'palm' does not exist in robot 'arm'",
                                      "1.5 rad is outside the limits -1 to 1 rad of joint 'wrist'",
                                      "group 'gripper' is not defined"}));
  EXPECT_EQ(editor.diagnostics("/ws/arm.srdf")[0]["range"]["start"]["line"], 2);

  // The robot changes in the editor, and the SRDF with it.
  std::string robot(kSrdfRobot);
  robot.replace(robot.find("upper='1'"), 9, "upper='2'");
  editor.open("/ws/arm.urdf", kSrdfRobot);
  editor.change("/ws/arm.urdf", robot);
  EXPECT_EQ(messages(editor, "/ws/arm.srdf").size(), 2U);
}

TEST(LspCompanions, AnSrdfWithoutARobotIsSaidToBeUnchecked) {
  MemoryDisk disk(test::Files{{"/ws/arm.urdf", kSrdfRobot}});
  Editor editor(disk);
  editor.open("/ws/leg.srdf", "<robot name='leg'><group name='g'><link name='x'/></group></robot>");
  EXPECT_EQ(messages(editor, "/ws/leg.srdf"),
            (std::vector<std::string>{
                "no robot in the workspace is named 'leg': names are not checked"}));
  EXPECT_EQ(editor.diagnostics("/ws/leg.srdf")[0]["severity"], 3);
  editor.open("/ws/cut.srdf", "<robot name='leg'><group");
  EXPECT_EQ(messages(editor, "/ws/cut.srdf").size(), 1U);
}

TEST(LspCompanions, FoldersThatAPackageExportsExist) {
  MemoryDisk disk(test::Files{{"/ws/p/models/box/model.config", ""}});
  Editor editor(disk);
  editor.open("/ws/p/package.xml",
              "<package format='3'>\n<name>p</name>\n<export>\n"
              "<gazebo_ros gazebo_model_path='${prefix}/models'/>\n"
              "<gazebo_ros gazebo_media_path='${prefix}/media'/>\n"
              "<gazebo_ros gazebo_model_path='${prefix}/..'/>\n</export>\n</package>\n");
  EXPECT_EQ(messages(editor, "/ws/p/package.xml"),
            (std::vector<std::string>{"folder 'media' does not exist in the package"}));
  EXPECT_EQ(editor.diagnostics("/ws/p/package.xml")[0]["range"]["start"]["line"], 4);
}

}  // namespace
}  // namespace rigor::lsp
