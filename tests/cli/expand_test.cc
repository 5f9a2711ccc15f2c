// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor expand` as a script would call it.

#include <gtest/gtest.h>

#include <string>

#include "cli/program.h"

namespace rigor::test {
namespace {

class ExpandProgram : public testing::Test {
 protected:
  void SetUp() override {
    folder_.put("ws/.git/config", "");
    folder_.put("ws/arm/package.xml", "<package><name>arm_description</name></package>");
    folder_.put("ws/arm/urdf/leg.xacro",
                "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
                "  <xacro:macro name=\"leg\" params=\"side\">\n"
                "    <link name=\"${side}_leg\"/>\n"
                "  </xacro:macro>\n"
                "</robot>\n");
    folder_.put("ws/robot/package.xml", "<package><name>robot</name></package>");
    folder_.put("ws/robot/robot.xacro",
                "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
                "  <xacro:arg name=\"side\" default=\"left\"/>\n"
                "  <xacro:include filename=\"$(find arm_description)/urdf/leg.xacro\"/>\n"
                "  <xacro:leg side=\"$(arg side)\"/>\n"
                "</robot>\n");
  }

  Folder folder_;
};

TEST_F(ExpandProgram, PrintsTheRobotWithPackagesOfItsWorkspace) {
  const Ran ran = folder_.rigor("expand ws/robot/robot.xacro side:=right");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("<robot name=\"r\">\n  <link name=\"right_leg\"/>\n</robot>\n"),
            std::string::npos)
      << ran.out;
}

TEST_F(ExpandProgram, WritesAFile) {
  EXPECT_EQ(folder_.rigor("expand ws/robot/robot.xacro -o out.urdf").exit, 0);
  EXPECT_NE(folder_.get("out.urdf").find("<link name=\"left_leg\"/>"), std::string::npos);
}

TEST_F(ExpandProgram, ListsWhatItRead) {
  const Ran ran = folder_.rigor("expand ws/robot/robot.xacro --deps");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_TRUE(ran.out.starts_with("ws/robot/robot.xacro\n")) << ran.out;
  EXPECT_TRUE(ran.out.ends_with("/ws/arm/urdf/leg.xacro\n")) << ran.out;
}

TEST_F(ExpandProgram, TracesAnElementToItsMacroAndCall) {
  const Ran ran = folder_.rigor("expand ws/robot/robot.xacro --trace 'robot/link[left_leg]@name'");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("leg.xacro:3:17: name=\"left_leg\", written ${side}_leg\n"),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("  in macro 'leg' (side='left'), called at ws/robot/robot.xacro:4:3\n"),
            std::string::npos)
      << ran.out;
  EXPECT_EQ(folder_.rigor("expand ws/robot/robot.xacro --trace robot/joint").exit, 2);
}

TEST_F(ExpandProgram, PrintsTheMapAsJson) {
  const Ran ran = folder_.rigor("expand ws/robot/robot.xacro --map json");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_NE(ran.out.find("\"/robot/link[1]\""), std::string::npos) << ran.out;
  EXPECT_EQ(folder_.rigor("expand ws/robot/robot.xacro --map yaml").exit, 2);
}

TEST_F(ExpandProgram, FailsWithThePlaceAndTheCalls) {
  folder_.put("bad.xacro",
              "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <xacro:macro name=\"leg\" params=\"n\"><l v=\"${n / 0}\"/></xacro:macro>\n"
              "  <xacro:leg n=\"1\"/>\n"
              "</robot>\n");
  const Ran ran = folder_.rigor("expand bad.xacro");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err,
            "bad.xacro:2:46: error: division by zero\n"
            "  in macro 'leg' (n='1'), called at bad.xacro:3:3\n");
}

TEST_F(ExpandProgram, RefusesWhatIsNoInvocation) {
  EXPECT_EQ(folder_.rigor("expand nothing.xacro").exit, 2);
  EXPECT_EQ(folder_.rigor("expand ws/robot/robot.xacro side=right").exit, 2);
}

}  // namespace
}  // namespace rigor::test
