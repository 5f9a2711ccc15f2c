// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor sdf2mjcf` and `rigor urdf2mjcf` as a script uses them.

#include <gtest/gtest.h>

#include <string>

#include "cli/conversion_models.h"

namespace rigor::test {
namespace {

class MjcfCli : public ConversionCli {};

TEST_F(MjcfCli, WritesTheRobotItsAssetsAndAScene) {
  folder.put("models/arm/meshes/a.obj",
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  folder.put("models/arm/model.sdf",
             arm("revolute",
                 "<link name='hull'><inertial><mass>1</mass></inertial><collision name='c'>"
                 "<geometry><mesh><uri>meshes/a.obj</uri><scale>2 2 2</scale></mesh></geometry>"
                 "</collision></link><joint name='w' type='fixed'><parent>tip</parent>"
                 "<child>hull</child></joint>"));
  folder.put("out/keep", "");
  const Ran ran = folder.rigor("sdf2mjcf models/arm/model.sdf -o out/arm.xml");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.err.find("20 joint positions"), std::string::npos) << ran.err;
  const std::string robot = folder.get("out/arm.xml");
  EXPECT_NE(robot.find("<mesh name=\"a\" file=\"a.stl\" scale=\"2 2 2\"/>"), std::string::npos);
  EXPECT_NE(folder.get("out/scene.xml").find("<include file=\"arm.xml\"/>"), std::string::npos);
  // 80 bytes of header, the count, four triangles.
  EXPECT_EQ(folder.get("out/assets/a.stl").size(), 84U + 4 * 50);
}

TEST_F(MjcfCli, ARobotComesBackAsItWent) {
  folder.put("assets/a.obj",
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  EXPECT_EQ(folder.rigor("mesh-check assets/a.obj -o assets/a.stl").exit, 0);
  const std::string mesh = "<geometry><mesh><uri>assets/a.stl</uri></mesh></geometry>";
  folder.put("arm.sdf",
             arm("revolute",
                 "<link name='hull'><inertial><mass>1</mass></inertial><visual name='visual'>" +
                     mesh + "</visual><collision name='collision'>" + mesh +
                     "</collision></link><joint name='hull_fixed' type='fixed'>"
                     "<parent>tip</parent><child>hull</child></joint>"));
  folder.put("out/keep", "");
  const Ran there = folder.rigor("sdf2mjcf arm.sdf -o out/arm.xml --format concise");
  EXPECT_EQ(there.exit, 0);
  EXPECT_NE(there.out.find("convert-mjcf-velocity"), std::string::npos) << there.out;
  // One file for what is drawn and what collides.
  EXPECT_NE(folder.get("out/arm.xml").find("file=\"a.stl\""), std::string::npos);
  EXPECT_FALSE(exists("out/assets/a_2.stl"));
  EXPECT_EQ(folder.rigor("mjcf2sdf out/arm.xml -o out/arm.sdf").exit, 0);
  // What was told to be lost differs, and that a geom is gray by default; nothing else.
  const Ran ran = folder.rigor("diff arm.sdf out/arm.sdf");
  EXPECT_NE(ran.out.find("joint elbow: velocity 2 rad/s"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("visual hull/visual: color added: 0.5 0.5 0.5 1"), std::string::npos)
      << ran.out;
  EXPECT_NE(ran.err.find("rigor: 2 differences\n"), std::string::npos) << ran.out << ran.err;
}

TEST_F(MjcfCli, AModelThatIsNotThereIsAWrongInvocation) {
  EXPECT_EQ(folder.rigor("sdf2mjcf arm.sdf -o out.xml --format concise").exit, 0);
  for (const char* command : {"mjcf2urdf", "mjcf2sdf"}) {
    const Ran ran = folder.rigor(std::string(command) + " out.xml --model tipp");
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_NE(ran.err.find("did you mean \"tip\"?"), std::string::npos) << ran.err;
  }
}

TEST_F(MjcfCli, ARobotWithoutLinksIsNone) {
  folder.put("none.urdf", "<robot name='none'/>");
  const Ran ran = folder.rigor("urdf2mjcf none.urdf -o none.xml --format concise");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("convert-no-model"), std::string::npos) << ran.out;
  EXPECT_FALSE(exists("none.xml"));
}

TEST_F(MjcfCli, ASceneIncludesTheFileThatIsWritten) {
  for (const char* name : {"arm", "arm.mjcf", "arm.v2.xml"}) {
    const std::string file = "out/" + std::string(name);
    folder.put("out/keep", "");
    std::filesystem::remove(folder.path("out/scene.xml"));
    EXPECT_EQ(folder.rigor("sdf2mjcf arm.sdf -o " + file).exit, 0);
    EXPECT_TRUE(exists(file));
    const Ran ran = folder.rigor("inspect out/scene.xml");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_NE(ran.out.find("tip"), std::string::npos) << name << '\n' << ran.out << ran.err;
  }
}

TEST_F(MjcfCli, WritesTheRobotAloneToStdout) {
  const Ran ran = folder.rigor("sdf2mjcf arm.sdf");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("<mujoco model=\"arm\">"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("range=\"-1 1\""), std::string::npos);
  EXPECT_FALSE(exists("scene.xml"));
}

TEST_F(MjcfCli, WritesNothingWhereTheRobotWouldBeAnother) {
  folder.put("bad.urdf", "<robot name='bad'>" + urdf_link("base") + urdf_link("tip", "5") +
                             urdf_joint("j", "continuous", "base", "tip", "<axis xyz='0 0 1'/>") +
                             "</robot>");
  const Ran refused = folder.rigor("urdf2mjcf bad.urdf -o bad.xml --format concise");
  EXPECT_EQ(refused.exit, 1);
  EXPECT_NE(refused.out.find("convert-mjcf-inertia"), std::string::npos) << refused.out;
  EXPECT_FALSE(exists("bad.xml"));
  EXPECT_EQ(folder.rigor("urdf2mjcf bad.urdf -o bad.xml --allow-loss").exit, 0);
  EXPECT_TRUE(exists("bad.xml"));
}

TEST_F(MjcfCli, ComparesWithARobotKeptByHand) {
  const Ran same = folder.rigor("sdf2mjcf arm.sdf --check arm.sdf");
  EXPECT_EQ(same.exit, 0) << same.err;
  std::string longer = folder.get("arm.sdf");
  longer.replace(longer.find("0.50"), 4, "0.51");
  folder.put("longer.sdf", longer);
  EXPECT_EQ(folder.rigor("sdf2mjcf arm.sdf --check longer.sdf").exit, 1);
}

TEST_F(MjcfCli, SameBytesGiveTheSameBytes) {
  EXPECT_EQ(folder.rigor("sdf2mjcf arm.sdf").out, folder.rigor("sdf2mjcf arm.sdf").out);
}

constexpr const char* kMjcfArm = R"(<mujoco model="arm"><compiler angle="radian"/><worldbody>
  <body name="base" pos="0 0 1"><freejoint/><geom name="foot" type="box" size=".1 .1 .1"/>
    <body name="tip" pos="0 0 .5"><joint name="elbow" axis="0 0 1" range="-1 1"/>
      <geom name="ball" type="ellipsoid" size=".1 .2 .3"/></body></body></worldbody></mujoco>)";

TEST_F(MjcfCli, WritesUrdfAndSdfOfMjcf) {
  folder.put("arm.xml", kMjcfArm);
  const Ran urdf = folder.rigor("mjcf2urdf arm.xml -o arm.urdf --name robot");
  EXPECT_EQ(urdf.exit, 0) << urdf.err;
  EXPECT_NE(urdf.err.find("20 joint positions"), std::string::npos) << urdf.err;
  EXPECT_NE(folder.get("arm.urdf").find("<robot name=\"robot\">"), std::string::npos);
  EXPECT_TRUE(exists("ellipsoid-0.1x0.2x0.3.stl"));
  const Ran sdf = folder.rigor("mjcf2sdf arm.xml");
  EXPECT_EQ(sdf.exit, 0) << sdf.err;
  EXPECT_NE(sdf.out.find("<ellipsoid>"), std::string::npos) << sdf.out;
  EXPECT_EQ(folder.rigor("mjcf2urdf arm.xml --check arm.urdf").exit, 0);
  EXPECT_EQ(folder.rigor("mjcf2sdf arm.xml --model leg").exit, 2);
  const Ran wrong = folder.rigor("mjcf2sdf arm.sdf");
  EXPECT_EQ(wrong.exit, 1);
  EXPECT_NE(wrong.err.find("holds no MJCF"), std::string::npos) << wrong.err;
}

TEST_F(MjcfCli, KeepsTheSceneAndTheMeshesOfAnotherRobot) {
  const std::string mesh =
      "<link name='hull'><inertial><mass>1</mass></inertial><collision name='c'>"
      "<geometry><mesh><uri>a.obj</uri></mesh></geometry></collision></link>"
      "<joint name='w' type='fixed'><parent>tip</parent><child>hull</child></joint>";
  const auto tetrahedron = [](const std::string& top) {
    return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 " + top + "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  };
  folder.put("out/keep", "");
  folder.put("one/a.obj", tetrahedron("1"));
  folder.put("one/m.sdf", arm("revolute", mesh));
  folder.put("two/a.obj", tetrahedron("2"));
  folder.put("two/m.sdf", arm("revolute", mesh));
  EXPECT_EQ(folder.rigor("sdf2mjcf one/m.sdf -o out/one.xml").exit, 0);
  const std::string scene = folder.get("out/scene.xml");
  const Ran refused = folder.rigor("sdf2mjcf two/m.sdf -o out/two.xml");
  EXPECT_EQ(refused.exit, 2);
  EXPECT_NE(refused.err.find("is another file"), std::string::npos) << refused.err;
  EXPECT_EQ(folder.rigor("sdf2mjcf arm.sdf -o out/three.xml").exit, 0);
  EXPECT_EQ(folder.get("out/scene.xml"), scene);
  EXPECT_NE(folder.get("out/three_scene.xml").find("three.xml"), std::string::npos);
  EXPECT_EQ(folder.rigor("sdf2mjcf one/m.sdf -o out/one.xml").exit, 0);
}

TEST_F(MjcfCli, AnSrdfGivesTheKeyframeAndThePairsThatDoNotTouch) {
  folder.put("arm.srdf",
             "<robot name='arm'><group name='g'><joint name='elbow'/></group>"
             "<group_state name='other' group='g'><joint name='elbow' value='-.5'/></group_state>"
             "<group_state name='home' group='g'><joint name='elbow' value='.25'/></group_state>"
             "<disable_collisions link1='tip' link2='base' reason='Adjacent'/></robot>");
  const Ran ran = folder.rigor("sdf2mjcf arm.sdf --srdf arm.srdf");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("<exclude body1=\"base\" body2=\"tip\"/>"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find(" 0.25\""), std::string::npos) << ran.out;
  EXPECT_EQ(folder.rigor("sdf2mjcf arm.sdf --srdf arm.sdf").exit, 2);
}

/// A part of a robot is not weighed, compared or converted as if it were the robot.
TEST_F(MjcfCli, WhatIsNotReadToItsEndIsRefused) {
  folder.put("many.xml",
             "<mujoco><worldbody><replicate count='60000' offset='1 0 0'><body><geom size='.1' "
             "mass='1'/></body></replicate></worldbody></mujoco>");
  folder.put("out/keep", "");
  const Ran checked = folder.rigor("validate many.xml --format concise");
  EXPECT_EQ(checked.exit, 1);
  EXPECT_NE(checked.out.find("[mjcf-too-large]"), std::string::npos) << checked.out;
  for (const char* command :
       {"inertia many.xml", "inspect many.xml --format tsv", "mjcf2urdf many.xml -o out/many.urdf",
        "mjcf2sdf many.xml -o out/many.sdf"}) {
    const Ran ran = folder.rigor(command);
    EXPECT_EQ(ran.exit, 1) << command << ran.err;
    EXPECT_NE((ran.out + ran.err).find("not read to its end"), std::string::npos)
        << command << (ran.out + ran.err).substr(0, 2000);
  }
  EXPECT_FALSE(exists("out/many.urdf"));
  EXPECT_FALSE(exists("out/many.sdf"));
  EXPECT_NE(folder.rigor("diff many.xml many.xml").exit, 0);
  EXPECT_NE(folder.rigor("simulate many.xml").exit, 0);
}

}  // namespace
}  // namespace rigor::test
