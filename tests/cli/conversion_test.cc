// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor sdf2urdf` and `rigor urdf2sdf` as a script uses them: what is written where, and exit codes.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/conversion_models.h"

namespace rigor::test {
namespace {

/// URDF has no loops: who needs one writes the joint that closes it into a block, which libsdformat reads.
TEST_F(ConversionCli, AJointInABlockOfGazeboIsInTheResult) {
  folder.put("loop.urdf",
             "<robot name='r'>" + urdf_link("a") + urdf_link("b") + urdf_link("c") +
                 urdf_joint("left", "continuous", "a", "b", "<axis xyz='0 0 1'/>") +
                 urdf_joint("right", "continuous", "a", "c", "<axis xyz='0 0 1'/>") +
                 "<gazebo><joint name='loop' type='revolute'><parent>b</parent><child>c</child>"
                 "<axis><xyz>0 0 1</xyz></axis></joint></gazebo></robot>");
  const Ran ran = folder.rigor("urdf2sdf loop.urdf");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("<joint name='loop' type='revolute'>"), std::string::npos) << ran.out;
}

/// As the PR2 has them, for a screw that URDF has not.
TEST_F(ConversionCli, LinksInABlockOfGazeboAreNoOtherRobot) {
  folder.put("screw.urdf",
             "<robot name='r'>" + urdf_link("a") +
                 "<gazebo><link name='motor'><inertial><mass>0.2</mass></inertial></link>"
                 "<joint name='turn' type='revolute'><parent>a</parent><child>motor</child>"
                 "<axis><xyz>0 0 1</xyz></axis></joint></gazebo></robot>");
  const Ran ran = folder.rigor("urdf2sdf screw.urdf");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("<link name='motor'>"), std::string::npos) << ran.out;
}

TEST_F(ConversionCli, WritesTheModelToStdoutAndTheRestToStderr) {
  const Ran ran = folder.rigor("sdf2urdf arm.sdf");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_TRUE(ran.out.starts_with("<?xml")) << ran.out;
  EXPECT_NE(ran.out.find("<joint name=\"elbow\" type=\"revolute\">"), std::string::npos);
  EXPECT_NE(ran.out.find("xyz=\"0 0 0.50\""), std::string::npos) << "the author's digits";
  EXPECT_NE(ran.err.find("20 joint positions"), std::string::npos) << ran.err;
}

TEST_F(ConversionCli, RefusesAReportWhereTheModelGoes) {
  const Ran ran = folder.rigor("sdf2urdf arm.sdf --format json");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_NE(ran.err.find("--report json:FILE"), std::string::npos);
  EXPECT_EQ(folder.rigor("sdf2urdf arm.sdf --report json:report.json").exit, 0);
  EXPECT_TRUE(exists("report.json"));
}

TEST_F(ConversionCli, MeshesAreFoundFromWhereverTheResultStands) {
  folder.put("models/arm/model.config",
             "<model><name>arm</name><sdf version='1.9'>model.sdf</sdf></model>");
  folder.put("models/arm/meshes/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.put("models/arm/model.sdf",
             arm("revolute",
                 "<link name='hull'><inertial><mass>1</mass></inertial><visual "
                 "name='v'><geometry><mesh><uri>meshes/a.obj</uri></mesh></geometry>"
                 "</visual></link><joint name='w' type='fixed'><parent>tip</parent>"
                 "<child>hull</child></joint>"));
  const auto mesh = [this](const std::string& out, const std::string& how = "") {
    const Ran ran = folder.rigor("sdf2urdf models/arm -o " + out + " " + how);
    EXPECT_EQ(ran.exit, 0) << ran.err;
    const Ran found = folder.rigor("validate --select mesh-not-found " + out);
    EXPECT_EQ(found.exit, 0) << found.out;
    const std::string text = folder.get(out);
    const std::size_t at = text.find("<mesh filename=\"") + 16;
    return text.substr(at, text.find('"', at) - at);
  };
  folder.put("elsewhere/deep/keep", "");
  EXPECT_EQ(mesh("models/arm/arm.urdf"), "package://arm/meshes/a.obj");
  EXPECT_EQ(mesh("elsewhere/deep/arm.urdf"), "../../models/arm/meshes/a.obj");
  EXPECT_EQ(
      mesh("elsewhere/deep/file.urdf", "--mesh-uri file"),
      "file://" + std::filesystem::canonical(folder.path("models/arm/meshes/a.obj")).string());
}

TEST_F(ConversionCli, AccountsForEveryElementAndAttribute) {
  EXPECT_EQ(folder.rigor("sdf2urdf arm.sdf -o arm.urdf --format json >all.json").exit, 0);
  const auto report =
      nlohmann::json::parse(folder.rigor("sdf2urdf arm.sdf -o a.urdf --format json").out);
  std::size_t sum = 0;
  for (const auto& [outcome, count] : report["account"].items()) sum += count.get<std::size_t>();
  // model@name; link@name, inertial, mass, inertia and three moments twice; joint with two attributes,
  // pose with one, parent, child, axis, xyz, limit and four numbers; each element itself besides.
  EXPECT_EQ(sum, 2U + 2 * 8 + 3 + 2 + 2 + 3 + 4);
  EXPECT_EQ(report["account"]["lost"], 0);
  EXPECT_EQ(report["verified_configurations"], 20);
}

TEST_F(ConversionCli, ALossThatIsAnErrorWritesNothingUnlessItIsAllowed) {
  folder.put("ball.sdf", arm("ball"));
  EXPECT_EQ(folder.rigor("sdf2urdf ball.sdf -o ball.urdf").exit, 1);
  EXPECT_FALSE(exists("ball.urdf"));
  EXPECT_EQ(folder.rigor("sdf2urdf ball.sdf").out, "");
  EXPECT_EQ(folder.rigor("sdf2urdf ball.sdf -o ball.urdf --allow-loss").exit, 0);
  EXPECT_TRUE(exists("ball.urdf"));

  folder.put("loop.sdf", arm("revolute",
                             "<joint name='again' type='fixed'><parent>base</parent>"
                             "<child>tip</child></joint>"));
  EXPECT_EQ(folder.rigor("sdf2urdf loop.sdf -o loop.urdf").exit, 1);
  EXPECT_FALSE(exists("loop.urdf"));
  EXPECT_EQ(folder.rigor("sdf2urdf loop.sdf -o loop.urdf --allow-loss").exit, 0);
}

TEST_F(ConversionCli, AGearboxIsProvedAsTheMimicThatStandsForIt) {
  const auto link = [](const std::string& name) {
    return "<link name='" + name + "'><inertial><mass>1</mass><inertia><ixx>.1</ixx><iyy>.1</iyy>" +
           "<izz>.1</izz></inertia></inertial></link>";
  };
  const auto wheel = [](const std::string& name) {
    return "<joint name='to_" + name + "' type='revolute'><parent>base</parent><child>" + name +
           "</child><axis><xyz>0 0 1</xyz></axis></joint>";
  };
  folder.put("gears.sdf", "<sdf version='1.9'><model name='gears'>" + link("base") + link("a") +
                              link("b") + wheel("a") + wheel("b") +
                              "<joint name='g' type='gearbox'><parent>a</parent><child>b</child>"
                              "<gearbox_ratio>3</gearbox_ratio>"
                              "<gearbox_reference_body>base</gearbox_reference_body>"
                              "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 0 1</xyz></axis2></joint>"
                              "</model></sdf>");
  EXPECT_EQ(folder.rigor("sdf2urdf gears.sdf -o gears.urdf").exit, 1) << "a joint less is an error";
  const Ran ran = folder.rigor("sdf2urdf gears.sdf -o gears.urdf --allow-loss");
  EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
  EXPECT_NE(folder.get("gears.urdf").find("multiplier=\"-3\""), std::string::npos);
}

TEST_F(ConversionCli, ChoosesOneOfSeveralModels) {
  folder.put("lab.sdf", "<sdf version='1.9'><world name='lab'><model name='a'>" + link_named("x") +
                            "</model><model name='b'>" + link_named("y") +
                            "</model></world></sdf>");
  EXPECT_EQ(folder.rigor("sdf2urdf lab.sdf").exit, 1);
  const Ran ran = folder.rigor("sdf2urdf lab.sdf --model b");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("<link name=\"y\">"), std::string::npos);
  EXPECT_EQ(ran.out.find("<link name=\"x\">"), std::string::npos);
}

TEST_F(ConversionCli, ChecksAHandKeptFile) {
  ASSERT_EQ(folder.rigor("sdf2urdf arm.sdf -o arm.urdf").exit, 0);
  EXPECT_EQ(folder.rigor("sdf2urdf arm.sdf --check arm.urdf").exit, 0);
  std::string moved = folder.get("arm.urdf");
  const std::size_t at = moved.find("0 0 0.50");
  ASSERT_NE(at, std::string::npos);
  moved.replace(at, 8, "0 0 0.51");
  folder.put("arm.urdf", moved);
  const Ran ran = folder.rigor("sdf2urdf arm.sdf --check arm.urdf");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("10 mm"), std::string::npos) << ran.out;
}

TEST_F(ConversionCli, GoesThereAndBack) {
  ASSERT_EQ(folder.rigor("sdf2urdf arm.sdf -o arm.urdf").exit, 0);
  ASSERT_EQ(folder.rigor("urdf2sdf arm.urdf -o back.sdf").exit, 0);
  EXPECT_EQ(folder.rigor("diff arm.sdf back.sdf").exit, 0);
  EXPECT_EQ(folder.rigor("validate back.sdf").exit, 0);
}

TEST_F(ConversionCli, FixesAStaticModelToTheWorldWhenAsked) {
  folder.put("wall.sdf", "<sdf version='1.9'><model name='wall'><static>true</static>" +
                             link_named("x") + "</model></sdf>");
  const std::string world = "<link name=\"world\"/>";
  EXPECT_EQ(folder.rigor("sdf2urdf wall.sdf").out.find(world), std::string::npos);
  EXPECT_NE(folder.rigor("sdf2urdf wall.sdf --static world-link").out.find(world),
            std::string::npos);
}

TEST_F(ConversionCli, WritesShapesThatBecomeMeshesBesideTheResult) {
  std::string model = arm("revolute");
  model.insert(
      model.find("</link>"),
      "<collision name='c'><geometry><ellipsoid><radii>1 2 3</radii></ellipsoid></geometry>"
      "</collision>");
  folder.put("egg.sdf", model);
  EXPECT_EQ(folder.rigor("sdf2urdf egg.sdf --shapes mesh").exit, 2) << "there is no place for it";
  EXPECT_EQ(folder.rigor("sdf2urdf egg.sdf --shapes mesh -o out.urdf").exit, 0);
  const std::string urdf = folder.get("out.urdf");
  const std::size_t at = urdf.find("<mesh filename=\"");
  ASSERT_NE(at, std::string::npos);
  const std::size_t begin = at + 16;
  EXPECT_TRUE(exists(urdf.substr(begin, urdf.find('"', begin) - begin)));
}

TEST_F(ConversionCli, SaysWhatIsNoInputForIt) {
  folder.put("broken.sdf", "<sdf version='1.9'><model name='a'");
  EXPECT_EQ(folder.rigor("sdf2urdf broken.sdf").exit, 1);
  EXPECT_EQ(folder.rigor("urdf2sdf arm.sdf").exit, 1);
  EXPECT_EQ(folder.rigor("sdf2urdf nowhere.sdf").exit, 2);
  EXPECT_EQ(folder.rigor("sdf2urdf arm.sdf --mesh-uri http://x").exit, 2);
  EXPECT_EQ(folder.rigor("sdf2urdf arm.sdf --loop maybe").exit, 2);
  EXPECT_EQ(folder.rigor("sdf2urdf arm.sdf --output robot.urdf").exit, 2);
}

/// Infos are for -v, but for those that tell of a loss.
TEST_F(ConversionCli, WhatIsLostIsTold) {
  std::string text = arm("revolute");
  const std::string base = "<link name='base'>";
  text.insert(text.find(base) + base.size(),
              "<pose>0 0 0.5 0 0 0</pose><light name='lamp' type='point'/>");
  folder.put("raised.sdf", text);
  const Ran ran = folder.rigor("sdf2urdf raised.sdf");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.err.find("convert-root-pose"), std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.find("convert-light"), std::string::npos) << "it is in a block";
  EXPECT_NE(ran.out.find("<light name='lamp'"), std::string::npos) << ran.out;
  const Ran all = folder.rigor("sdf2urdf raised.sdf -v");
  EXPECT_NE(all.err.find("the light is for Gazebo only"), std::string::npos) << all.err;
}

/// A kept file is held against what the result would tell a simulator, too.
TEST_F(ConversionCli, CheckSeesBlocks) {
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>"
      "</inertial>";
  folder.put("a.urdf", "<robot name='r'><link name='a'>" + inertial +
                           "<collision name='c'><geometry><sphere radius='1'/></geometry>"
                           "</collision></link><link name='b'>" +
                           inertial +
                           "</link><joint name='j' type='continuous'><parent link='a'/>"
                           "<child link='b'/><axis xyz='0 0 1'/></joint>"
                           "<gazebo reference='j'><springStiffness>12</springStiffness></gazebo>"
                           "<gazebo reference='a'><mu1>0.25</mu1></gazebo></robot>");
  EXPECT_EQ(folder.rigor("urdf2sdf a.urdf -o a.sdf").exit, 0);
  EXPECT_EQ(folder.rigor("urdf2sdf a.urdf --check a.sdf").exit, 0);
  const auto checked = [this](const std::string& from, const std::string& to) {
    std::string text = folder.get("a.sdf");
    const std::size_t at = text.find(from);
    if (at == std::string::npos) return "no " + from + " in " + text;
    folder.put("b.sdf", text.replace(at, from.size(), to));
    const Ran ran = folder.rigor("urdf2sdf a.urdf --check b.sdf");
    EXPECT_EQ(ran.exit, 1);
    return ran.out;
  };
  EXPECT_NE(checked("<mu>0.25<", "<mu>0.5<").find("surface/friction/ode/mu 0.25 → 0.5"),
            std::string::npos);
  EXPECT_NE(checked(">12<", ">13<").find("spring stiffness 12 → 13"), std::string::npos);
}

/// What a policy or an allowed loss changes on purpose does not fail the proof.
TEST_F(ConversionCli, TheProofKnowsWhatWasAskedFor) {
  const auto urdf_link = [](const std::string& name, const std::string& more = "") {
    return "<link name='" + name +
           "'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' " +
           "iyy='1' iyz='0' izz='1'/></inertial>" + more + "</link>";
  };
  const auto urdf_joint = [](const std::string& name, const std::string& type,
                             const std::string& parent, const std::string& child,
                             const std::string& more = "") {
    return "<joint name='" + name + "' type='" + type + "'><origin xyz='0 1 0'/><parent link='" +
           parent + "'/><child link='" + child + "'/><axis xyz='0 0 1'/>" + more + "</joint>";
  };
  folder.put("arm.urdf", "<robot name='arm'>" + urdf_link("a") + urdf_link("b") + urdf_link("c") +
                             urdf_link("d") + urdf_joint("ab", "fixed", "a", "b") +
                             urdf_joint("bc", "continuous", "b", "c") +
                             urdf_joint("cd", "continuous", "c", "d",
                                        "<mimic joint='bc' multiplier='2' offset='0'/>") +
                             "</robot>");
  folder.put("cover.urdf", "<robot name='v'>" + urdf_link("a") +
                               "<link name='cover'><visual><geometry><sphere radius='1'/>"
                               "</geometry></visual></link>" +
                               urdf_joint("j", "fixed", "a", "cover") + "</robot>");
  folder.put(
      "capsule.sdf",
      arm("revolute",
          "<link name='k'><inertial><mass>1</mass><inertia><ixx>1</ixx></inertia></inertial>"
          "<collision name='b'><geometry><box><size>1 1 1</size></box></geometry></collision>"
          "<collision name='k'><geometry><capsule><radius>1</radius><length>1</length>"
          "</capsule></geometry></collision></link><joint name='f' type='fixed'>"
          "<parent>tip</parent><child>k</child></joint>"));
  std::string placed = arm("revolute",
                           "<joint name='w' type='fixed'><parent>world</parent>"
                           "<child>base</child></joint>");
  const std::string model = "<model name='arm'>";
  placed.insert(placed.find(model) + model.size(), "<pose>0 0 2 0 0 0</pose>");
  folder.put("placed.sdf", placed);
  folder.put("free.sdf", arm("continuous"));
  const auto proved = [this](const std::string& arguments) {
    const Ran ran = folder.rigor(arguments);
    EXPECT_EQ(ran.exit, 0) << arguments << ran.err;
    EXPECT_EQ(ran.err.find("convert-not-the-same"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("20 joint positions"), std::string::npos) << ran.err;
    return ran.out;
  };
  EXPECT_EQ(proved("urdf2sdf arm.urdf --fixed lump").find("<link name=\"b\">"), std::string::npos);
  proved("urdf2sdf arm.urdf --sdf-version 1.9 --allow-loss");
  EXPECT_NE(proved("urdf2sdf cover.urdf").find("<link name=\"cover\">"), std::string::npos);
  EXPECT_NE(proved("urdf2sdf cover.urdf --massless link").find("<link name=\"cover\">"),
            std::string::npos);
  EXPECT_EQ(proved("urdf2sdf cover.urdf --massless frame").find("<link name=\"cover\">"),
            std::string::npos);
  EXPECT_NE(proved("sdf2urdf capsule.sdf --urdf-version 1.1").find("<capsule"), std::string::npos);
  EXPECT_NE(proved("sdf2urdf placed.sdf --model-pose world-link").find("xyz=\"0 0 2\""),
            std::string::npos);
  proved("sdf2urdf free.sdf --unlimited 1000");
}

/// No body has izz > ixx + iyy; libsdformat 12: "A link named a has invalid inertia."
TEST_F(ConversionCli, WhatLibsdformatRejectsIsNoSuccess) {
  folder.put("r.urdf", "<robot name='r'>" + urdf_link("a", "9") + "</robot>");
  const Ran ran = folder.rigor("urdf2sdf r.urdf -o r.sdf");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_FALSE(exists("r.sdf"));
  EXPECT_NE(ran.out.find("convert-rejected-by-libsdformat"), std::string::npos) << ran.out;
  EXPECT_NE(ran.err.find("--allow-loss"), std::string::npos) << ran.err;
}

/// The second moments are (4.5, 4.5, -3.5): the last becomes 1e-4 of the sum of the others, 9.
TEST_F(ConversionCli, TheNearestPossibleInertiaIsWrittenWhereItIsAskedFor) {
  folder.put("r.urdf", "<robot name='r'>" + urdf_link("a", "9") + "</robot>");
  for (const std::string option : {"--inertia nearest", "--allow-loss"}) {
    const Ran ran = folder.rigor("urdf2sdf r.urdf -o r.sdf " + option);
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("warning[convert-inertia-nearest]"), std::string::npos) << ran.out;
    EXPECT_EQ(ran.out.find("convert-rejected-by-libsdformat"), std::string::npos) << ran.out;
    const std::string sdf = folder.get("r.sdf");
    EXPECT_NE(sdf.find("<ixx>4.5009</ixx>"), std::string::npos) << sdf;
    EXPECT_NE(sdf.find("<izz>9</izz>"), std::string::npos) << sdf;
  }
  EXPECT_EQ(folder.rigor("urdf2sdf r.urdf -o kept.sdf --allow-loss --inertia keep").exit, 0);
  EXPECT_NE(folder.get("kept.sdf").find("<ixx>1</ixx>"), std::string::npos);
}

TEST_F(ConversionCli, ReadsWhatOthersReadOnlyWhereLossesAreAllowed) {
  folder.put("incomplete.urdf",
             "<robot name='r'><link name='a'><inertial><mass value='1'/>"
             "<inertia ixx='1' iyy='1' izz='1'/></inertial></link></robot>");
  folder.put("free.urdf", "<robot name='r'><link name='world'/>" + urdf_link("b") +
                              urdf_joint("j", "floating", "world", "b") + "</robot>");
  for (const std::string name : {"incomplete", "free"}) {
    const std::string convert = "urdf2sdf " + name + ".urdf -o " + name + ".sdf";
    EXPECT_EQ(folder.rigor(convert).exit, 1) << name;
    const Ran ran = folder.rigor(convert + " --allow-loss");
    EXPECT_EQ(ran.exit, 0) << name << ran.out << ran.err;
  }
  EXPECT_NE(folder.get("incomplete.sdf").find("<ixy>0</ixy>"), std::string::npos);
}

TEST_F(ConversionCli, BulletsSphericalJointIsABall) {
  folder.put("b.urdf", "<robot name='r'>" + urdf_link("a") + urdf_link("b") +
                           urdf_joint("j", "spherical", "a", "b") + "</robot>");
  const Ran ran = folder.rigor("urdf2sdf b.urdf");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("<joint name=\"j\" type=\"ball\">"), std::string::npos) << ran.out;
}

/// There and back, the camera hangs on the mast by the same joint.
TEST_F(ConversionCli, JointsOfLinksWithoutMassKeepTheirNames) {
  folder.put("r.urdf",
             "<robot name='r'>" + urdf_link("base") + "<link name='mast'/>" +
                 "<link name='camera'/>" +
                 urdf_joint("mast_joint", "fixed", "base", "mast", "<origin xyz='0 0 1'/>") +
                 urdf_joint("camera_joint", "fixed", "mast", "camera",
                            "<origin xyz='0.1 0 0' rpy='0 0.2 0'/>") +
                 "</robot>");
  const Ran to_sdf = folder.rigor("urdf2sdf r.urdf -o r.sdf");
  EXPECT_EQ(to_sdf.exit, 0) << to_sdf.out;
  const std::string sdf = folder.get("r.sdf");
  EXPECT_NE(sdf.find("<frame name=\"camera_joint\" attached_to=\"mast\">"), std::string::npos)
      << sdf;
  EXPECT_NE(sdf.find("<frame name=\"camera\" attached_to=\"camera_joint\"/>"), std::string::npos)
      << sdf;
  const Ran same = folder.rigor("diff r.urdf r.sdf");
  EXPECT_EQ(same.exit, 0) << same.out;
  const Ran back = folder.rigor("sdf2urdf r.sdf -o back.urdf");
  EXPECT_EQ(back.exit, 0) << back.out;
  const std::string urdf = folder.get("back.urdf");
  EXPECT_NE(urdf.find("<joint name=\"camera_joint\" type=\"fixed\">\n    <parent link=\"mast\"/>"),
            std::string::npos)
      << urdf;
  EXPECT_EQ(folder.rigor("diff r.urdf back.urdf").exit, 0);
}

/// The footprint is the root again.
TEST_F(ConversionCli, ARootWithoutMassComesBack) {
  folder.put("r.urdf", "<robot name='r'><link name='base_footprint'/>" + urdf_link("base_link") +
                           urdf_joint("base_joint", "fixed", "base_footprint", "base_link",
                                      "<origin xyz='0 0 0.10'/>") +
                           "</robot>");
  EXPECT_EQ(folder.rigor("urdf2sdf r.urdf -o r.sdf").exit, 0);
  const Ran same = folder.rigor("diff r.urdf r.sdf");
  EXPECT_EQ(same.exit, 0) << same.out;
  const Ran back = folder.rigor("sdf2urdf r.sdf -o back.urdf");
  EXPECT_EQ(back.exit, 0) << back.out;
  const Ran round = folder.rigor("diff r.urdf back.urdf");
  EXPECT_EQ(round.exit, 0) << round.out;
  EXPECT_NE(folder.get("back.urdf").find("xyz=\"0 0 0.10\""), std::string::npos);
}

TEST_F(ConversionCli, DiffSeesTheNamesOfFixedJoints) {
  const auto robot = [](const std::string& joint) {
    return "<robot name='r'>" + urdf_link("base") + "<link name='camera'/>" +
           urdf_joint(joint, "fixed", "base", "camera") + "</robot>";
  };
  folder.put("a.urdf", robot("lens"));
  folder.put("b.sdf",
             "<sdf version='1.9'><model name='r'><link name='base'><inertial><mass>1</mass>"
             "<inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial></link>"
             "<frame name='camera' attached_to='base'/></model></sdf>");
  const Ran ran = folder.rigor("diff a.urdf b.sdf");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("lens"), std::string::npos) << ran.out;
}

constexpr const char* kTriangle =
    "<collision name='c'><geometry><polyline><point>0 0</point><point>1 0</point><point>0 1</point>"
    "<height>2</height></polyline></geometry></collision>";
constexpr const char* kGround =
    "<collision name='c'><geometry><plane><normal>0 0 1</normal></plane></geometry></collision>";

std::string one_link(const std::string& content) {
  return "<sdf version='1.9'><model name='m'><link name='l'><inertial><mass>2</mass><inertia>"
         "<ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>" +
         content + "</link></model></sdf>";
}

TEST_F(ConversionCli, APolylineBecomesAMeshBesideTheResult) {
  folder.put("p.sdf", one_link(kTriangle));
  folder.put("out/.keep", "");
  const Ran ran = folder.rigor("sdf2urdf p.sdf -o out/p.urdf");
  EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
  ASSERT_TRUE(exists("out/prism-1.stl"));
  // A prism over half a square of 1 m², 2 m high.
  const Ran mesh = folder.rigor("mesh-check out/prism-1.stl --format json");
  const auto report = nlohmann::json::parse(mesh.out);
  EXPECT_NEAR(report["meshes"][0]["volume"].get<double>(), 1, 1e-6);
  EXPECT_TRUE(report["meshes"][0]["watertight"].get<bool>());
}

TEST_F(ConversionCli, ALostCollisionIsNoSuccess) {
  folder.put("p.sdf", one_link(kTriangle));
  folder.put("g.sdf", one_link(kGround));
  EXPECT_EQ(folder.rigor("sdf2urdf p.sdf").exit, 1) << "no place for a file";
  EXPECT_EQ(folder.rigor("sdf2urdf p.sdf --allow-loss").exit, 0);
  EXPECT_EQ(folder.rigor("sdf2urdf g.sdf -o g.urdf").exit, 1);
  EXPECT_FALSE(exists("g.urdf"));
  const Ran box = folder.rigor("sdf2urdf g.sdf -o g.urdf --plane box");
  EXPECT_EQ(box.exit, 0) << box.out;
  const std::string urdf = folder.get("g.urdf");
  EXPECT_NE(urdf.find("<box size=\"100 100 0.02\"/>"), std::string::npos) << urdf;
  EXPECT_NE(urdf.find("<origin xyz=\"0 0 -0.01\"/>"), std::string::npos) << "its face in the plane";
}

TEST_F(ConversionCli, TheAccountIsInTheResultWhereItIsAskedFor) {
  EXPECT_EQ(folder.rigor("sdf2urdf arm.sdf").out.find("Converted from"), std::string::npos);
  EXPECT_NE(folder.rigor("sdf2urdf arm.sdf --header").out.find("Converted from arm.sdf"),
            std::string::npos);
}

TEST_F(ConversionCli, NothingToWriteIsAnErrorWhateverLossIsAllowed) {
  folder.put("two.urdf", "<robot name='r'>" + urdf_link("a") + urdf_link("b") + "</robot>");
  const Ran ran = folder.rigor("urdf2sdf two.urdf -o two.sdf --allow-loss");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("error[convert-several-roots]: 2 links are the child of no joint: a, b"),
            std::string::npos)
      << ran.out;
  EXPECT_EQ(ran.err.find("--allow-loss writes"), std::string::npos) << ran.err;
}

TEST_F(ConversionCli, FindingsOfOneCauseAreOne) {
  std::string meshes;
  for (const char* name : {"a", "b", "c"}) {
    meshes += "<visual><geometry><mesh filename='PLACE" + std::string(name) +
              ".stl'/></geometry></visual>";
  }
  const std::string robot =
      "<robot name='r'><link name='a'><inertial><mass value='1'/><inertia ixx='1' "
      "ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>" +
      meshes +
      "</link><transmission name='t'><type>x</type></transmission>"
      "<transmission name='u'><type>x</type></transmission></robot>";
  for (const std::string place : {"package://gone/", "meshes/", "file://r/meshes/"}) {
    folder.put("m.urdf", std::regex_replace(robot, std::regex("PLACE"), place));
    const Ran ran = folder.rigor("urdf2sdf m.urdf -o m.sdf");
    EXPECT_EQ(ran.exit, 0) << ran.out;
    for (const std::string rule : {"convert-uri-not-found", "convert-transmission"}) {
      const std::string head = "warning[" + rule + "]";
      const std::size_t first = ran.out.find(head);
      ASSERT_NE(first, std::string::npos) << ran.out;
      EXPECT_EQ(ran.out.find(head, first + 1), std::string::npos) << ran.out;
    }
  }
}

/// Which format lacks what is lost, and what to do about a mesh, which all have.
TEST_F(ConversionCli, WhatIsLostIsSaidOfTheTarget) {
  folder.put("ball.sdf", arm("ball"));
  const Ran ball = folder.rigor("sdf2urdf ball.sdf --format concise -o ball.urdf");
  EXPECT_NE(ball.out.find("error: URDF has no ball joint; with --allow-loss it becomes"),
            std::string::npos)
      << ball.out;
  const std::string plane = "<collision name='c'><geometry><plane/></geometry></collision>";
  folder.put("plane.sdf", "<sdf version='1.9'><model name='m'><link name='a'><inertial/>" + plane +
                              "</link></model></sdf>");
  const Ran flat = folder.rigor("sdf2urdf plane.sdf --format concise -o plane.urdf");
  EXPECT_NE(flat.out.find("URDF has no plane: the collision is left out"), std::string::npos)
      << flat.out;
  const Ran mjcf = folder.rigor("sdf2mjcf plane.sdf --format concise -o plane.xml");
  EXPECT_NE(mjcf.out.find("MJCF has no plane on a moving body"), std::string::npos) << mjcf.out;

  folder.put("mesh.urdf",
             "<robot name='r'><link name='a'><visual><geometry><mesh/></geometry>"
             "</visual></link></robot>");
  const Ran mesh = folder.rigor("urdf2sdf mesh.urdf -o mesh.sdf");
  EXPECT_NE(mesh.out.find("the mesh is left out: SDF needs it as a file"), std::string::npos)
      << mesh.out;
  EXPECT_NE(mesh.out.find("name the mesh file in the source"), std::string::npos) << mesh.out;
  for (const Ran& ran : {ball, flat, mjcf, mesh}) {
    EXPECT_EQ(ran.out.find("in the target"), std::string::npos) << ran.out;
  }
}

/// What stood in comments, in its shape, and without the banner of what made the file.
TEST_F(ConversionCli, CommentsAreThoseOfTheAuthor) {
  folder.put("c.urdf",
             "<?xml version='1.0'?>\n<!-- ====== -->\n"
             "<!-- | This document was autogenerated by xacro from c.xacro | -->\n"
             "<!-- | EDITING THIS FILE BY HAND IS NOT RECOMMENDED | -->\n"
             "<!-- ====== -->\n<!-- by hand -->\n<robot name='r'>\n"
             "  <!--\n  <link name='old'>\n    <visual/>\n  </link>\n  -->\n" +
                 urdf_link("a") + "\n</robot>\n");
  const std::string sdf = folder.rigor("urdf2sdf c.urdf").out;
  EXPECT_EQ(sdf.find("autogenerated"), std::string::npos) << sdf;
  EXPECT_EQ(sdf.find("====="), std::string::npos);
  EXPECT_NE(sdf.find("<!-- by hand -->"), std::string::npos);
  EXPECT_NE(sdf.find("    <!--\n    <link name='old'>\n      <visual/>\n    </link>\n    -->\n"),
            std::string::npos)
      << sdf;
}

}  // namespace
}  // namespace rigor::test
