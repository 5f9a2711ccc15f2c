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

}  // namespace
}  // namespace rigor::test
