// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor srdf`: a new file, one that is brought up to date, and what validate says of it.

#include <string>

#include <gtest/gtest.h>

#include <cli/program.h>

namespace rigor::test {
namespace {

/// An elbow that lets the hand reach the base, and a hand that never reaches the shoulder's ball.
constexpr const char* kReachingArm = R"(<robot name="arm">
  <link name="base">
    <collision><geometry><sphere radius="0.1"/></geometry></collision>
  </link>
  <link name="upper">
    <collision><origin xyz="0.5 0 0"/><geometry><box size="0.2 0.05 0.05"/></geometry></collision>
  </link>
  <link name="fore">
    <collision><origin xyz="0.8 0 0"/><geometry><sphere radius="0.15"/></geometry></collision>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <joint name="elbow" type="revolute">
    <origin xyz="1 0 0"/><parent link="upper"/><child link="fore"/><axis xyz="0 0 1"/>
    <limit lower="0.5" upper="3.1" effort="1" velocity="1"/>
  </joint>
</robot>
)";

TEST(SrdfCommand, WritesWhatValidateIsContentWith) {
  const Folder folder;
  folder.put("arm.urdf", kReachingArm);
  const Ran made = folder.rigor("srdf arm.urdf -o arm.srdf --samples 1000");
  EXPECT_EQ(made.exit, 0) << made.err;
  EXPECT_EQ(made.err,
            "rigor: 3 pairs: 2 adjacent, 0 in collision at rest, 0 always, 0 never in "
            "1,000 samples; 1 to check\n");
  EXPECT_EQ(folder.get("arm.srdf"), R"(<?xml version="1.0" encoding="UTF-8"?>
<robot name="arm">
    <group name="arm">
        <chain base_link="base" tip_link="fore"/>
    </group>
    <group_state name="home" group="arm">
        <joint name="shoulder" value="0"/>
        <joint name="elbow" value="1.8"/>
    </group_state>
    <virtual_joint name="virtual_joint" type="fixed" parent_frame="world" child_link="base"/>
    <disable_collisions link1="base" link2="upper" reason="Adjacent"/>
    <disable_collisions link1="upper" link2="fore" reason="Adjacent"/>
</robot>
)");
  const Ran checked = folder.rigor("validate arm.srdf");
  EXPECT_EQ(checked.exit, 0) << checked.out;
  EXPECT_EQ(checked.out.find("not-found"), std::string::npos) << checked.out;
  EXPECT_EQ(folder.rigor("srdf arm.urdf --samples 1000 -j 1").out, folder.get("arm.srdf"));
}

/// Robot and configuration in two packages, neither above the other.
TEST(SrdfCommand, ValidateFindsTheRobotOfTheSetupAssistant) {
  const Folder folder;
  folder.put("a/description/package.xml", "<package><name>arm_description</name></package>");
  folder.put("a/description/urdf/arm.urdf", kReachingArm);
  folder.put("b/c/d/e/config/package.xml", "<package><name>arm_moveit</name></package>");
  folder.put("b/c/d/e/config/.setup_assistant",
             "moveit_setup_assistant_config:\n  URDF:\n    package: arm_description\n"
             "    relative_path: urdf/arm.urdf\n  SRDF:\n    relative_path: config/arm.srdf\n");
  folder.put("b/c/d/e/config/config/arm.srdf",
             "<robot name=\"arm\"><passive_joint name=\"knee\"/></robot>\n");
  const std::string validate =
      "validate b/c/d/e/config/config/arm.srdf --format concise --show info";
  EXPECT_NE(folder.rigor(validate).out.find("srdf-robot-not-found"), std::string::npos);
  const Ran found = folder.rigor(validate + " --package arm_description=a/description");
  EXPECT_NE(found.out.find("srdf-name-undefined"), std::string::npos) << found.out;
}

TEST(SrdfCommand, UpdatesAMatrixAndNothingElse) {
  const Folder folder;
  folder.put("arm.urdf", kReachingArm);
  const std::string kept =
      "<robot name='arm'>\r\n\t<!-- kept -->\r\n"
      "\t<disable_collisions link1='fore' link2='base' reason='User'/>\r\n";
  const std::string old = kept +
                          "\t<disable_collisions link1='upper' link2='base' reason='Never'/>\r\n"
                          "\t<disable_collisions link1='upper' link2='gone' reason='Never'/>\r\n"
                          "</robot>\r\n";
  folder.put("arm.srdf", old);
  const Ran shown = folder.rigor("srdf arm.urdf --update arm.srdf");
  EXPECT_EQ(shown.exit, 0) << shown.err;
  EXPECT_NE(shown.out.find("-\t<disable_collisions link1='upper' link2='gone'"), std::string::npos)
      << shown.out;
  EXPECT_EQ(folder.get("arm.srdf"), old);
  EXPECT_EQ(folder.rigor("srdf arm.urdf --update arm.srdf --write").exit, 0);
  EXPECT_EQ(folder.get("arm.srdf"),
            kept +
                "\t<disable_collisions link1='upper' link2='base' reason='Adjacent'/>\r\n"
                "\t<disable_collisions link1='upper' link2='fore' reason='Adjacent'/>\r\n"
                "</robot>\r\n");
  const Ran again = folder.rigor("srdf arm.urdf --update arm.srdf");
  EXPECT_EQ(again.out, "") << again.out;
}

TEST(SrdfCommand, SaysWhichCollisionsAreUnknown) {
  const Folder folder;
  std::string text(kReachingArm);
  const std::string ball = "<sphere radius=\"0.1\"/>";
  text.replace(text.find(ball), ball.size(), "<mesh filename=\"lost.stl\"/>");
  folder.put("arm.urdf", text);
  const Ran ran = folder.rigor("srdf arm.urdf");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_NE(ran.err.find("collision of base is not checked: lost.stl is not found"),
            std::string::npos)
      << ran.err;
  EXPECT_EQ(ran.out.find("Never"), std::string::npos) << ran.out;
}

TEST(SrdfCommand, RefusesWhatIsNoSrdf) {
  const Folder folder;
  folder.put("arm.urdf", kReachingArm);
  folder.put("world.sdf", "<sdf version='1.9'/>");
  EXPECT_EQ(folder.rigor("srdf arm.urdf --update world.sdf").exit, 1);
  const Ran robot = folder.rigor("srdf arm.urdf --update arm.urdf --write");
  EXPECT_EQ(robot.exit, 1);
  EXPECT_NE(robot.err.find("arm.urdf is a URDF, not an SRDF: its <robot> has a <link>"),
            std::string::npos)
      << robot.err;
  EXPECT_EQ(folder.get("arm.urdf"), kReachingArm);
  EXPECT_EQ(folder.rigor("srdf arm.urdf --write").exit, 2);
  EXPECT_EQ(folder.rigor("srdf lost.urdf").exit, 2);
}

TEST(SrdfCommand, AFolderThatHoldsNothingElseIsChecked) {
  const Folder folder;
  folder.put("config/arm.srdf", "<robot name=\"arm\"><group name=\"g\"/></robot>\n");
  const Ran ran = folder.rigor("validate config --format concise --fail-on info");
  EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
  EXPECT_EQ(ran.err.find("holds no"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("1 file checked"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace rigor::test
