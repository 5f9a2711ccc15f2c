// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// MJCF to URDF and SDF, against numbers worked out by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

#include <rigor/text/grouping.h>

#include "convert/from_mjcf_converted.h"

namespace rigor::test {
namespace {

using Names = std::vector<std::string>;

constexpr const char* kSkin = "<geom type='box' size='.1 .2 .3' mass='2'/>";

std::string body(const std::string& name, const std::string& inside,
                 const std::string& attributes = {}) {
  return "<body name='" + name + "' " + attributes + ">" + kSkin + inside + "</body>";
}

TEST(FromMjcf, ABodyOnTheWorldHangsOnIt) {
  const FromMjcf urdf(body("base", "", "pos='0 0 1'"), ResultFormat::kUrdf);
  EXPECT_EQ(urdf.at("joint", "base_fixed", "parent/@link"), "world");
  EXPECT_EQ(urdf.at("joint", "base_fixed", "origin/@xyz"), "0 0 1");
  EXPECT_EQ(urdf.against(), Names{});
  const FromMjcf sdf(body("base", "", "pos='0 0 1'") + body("post", body("arm", "<joint/>")),
                     ResultFormat::kSdf);
  EXPECT_EQ(sdf.at("joint", "base_fixed", "parent"), "world");
  EXPECT_EQ(sdf.at("link", "base", "pose"), "0 0 1 0 0 0");
  EXPECT_EQ(sdf.against(), Names{});
}

TEST(FromMjcf, WhatNeverMovesIsStatic) {
  const FromMjcf sdf("<geom type='plane' size='1 1 1'/>" +
                         body("base", body("top", "", "pos='0 0 2'"), "pos='0 0 1'"),
                     ResultFormat::kSdf);
  EXPECT_EQ(sdf.all("static").size(), 1U);
  EXPECT_EQ(sdf.all("joint").size(), 1U);
  EXPECT_EQ(sdf.at("joint", "top_fixed", "parent"), "base");
  EXPECT_EQ(sdf.against(), Names{});
}

TEST(FromMjcf, AFreeBodyIsTheRoot) {
  const std::string text = body("base", "<freejoint/>", "pos='0 0 1'");
  const FromMjcf urdf(text, ResultFormat::kUrdf);
  EXPECT_TRUE(urdf.all("joint").empty());
  EXPECT_EQ(urdf.of_rule("convert-from-mjcf-root").size(), 1U);
  EXPECT_EQ(urdf.against(), Names{});
  const FromMjcf sdf(text, ResultFormat::kSdf);
  EXPECT_TRUE(sdf.all("joint").empty());
  EXPECT_EQ(sdf.against(), Names{});
}

TEST(FromMjcf, SeveralFreeBodiesFloat) {
  const FromMjcf urdf(body("a", "<freejoint/>") + body("b", "<freejoint name='fly'/>"),
                      ResultFormat::kUrdf);
  EXPECT_EQ(urdf.at("joint", "fly", "@type"), "floating");
  EXPECT_EQ(urdf.at("joint", "fly", "parent/@link"), "world");
  EXPECT_EQ(urdf.against(), Names{});
}

TEST(FromMjcf, WhatIsLostOfManyElementsIsOneFindingForEachAttribute) {
  const std::string soft = "<geom size='.1' solref='.02 1' condim='4'/>";
  const FromMjcf sdf(
      body("a", soft + body("b", soft, "pos='0 0 1'") + "<light pos='0 0 1'/><light name='sun'/>") +
          "<light pos='0 0 2'/>" + soft,
      ResultFormat::kSdf);
  std::map<std::string, std::size_t> places;  // by the words before ":"
  const Diagnostics groups = grouped(sdf.result.diagnostics);
  for (const Diagnostic& group : groups.list()) {
    if (!group.rule.starts_with("convert-from-mjcf")) continue;
    places[group.message.substr(0, group.message.find(' '))] += 1 + group.others.size();
    for (const Diagnostic& other : group.others) EXPECT_FALSE(other.where.nowhere());
  }
  EXPECT_EQ(places, (std::map<std::string, std::size_t>{
                        {"geom/@solref", 3}, {"geom/@condim", 3}, {"body/light", 3}}));
  EXPECT_EQ(sdf.of_rule("convert-from-mjcf-contact").size(), 6U);
  EXPECT_EQ(sdf.of_rule("convert-from-mjcf-look").size(), 3U);
}

TEST(FromMjcf, OneOfSeveralBodiesIsConvertedWhenItIsNamed) {
  convert::FromMjcfOptions how;
  how.body = "b";
  const FromMjcf urdf(body("a", "<freejoint/>") + body("b", "<freejoint/>"), ResultFormat::kUrdf,
                      how);
  EXPECT_EQ(urdf.all("link").size(), 1U);
  EXPECT_EQ(urdf.of_rule("convert-from-mjcf-left-out"),
            Names{"body a is left out: --model names another one (7 elements and attributes)"});
  how.body = "c";
  EXPECT_FALSE(FromMjcf(body("a", ""), ResultFormat::kUrdf, how).result.text);
}

/// A joint off its body's origin: URDF moves the link's frame there, SDF keeps it.
TEST(FromMjcf, AJointStandsWhereTheFileHasIt) {
  const std::string text =
      body("base", body("arm",
                        "<joint name='j' pos='.1 0 0' axis='0 0 2' range='-1 2' damping='.5' "
                        "frictionloss='.25' stiffness='3' springref='.5'/>",
                        "pos='1 0 0'"));
  const FromMjcf urdf(text, ResultFormat::kUrdf);
  EXPECT_EQ(urdf.at("joint", "j", "@type"), "revolute");
  EXPECT_EQ(urdf.at("joint", "j", "origin/@xyz"), "1.1 0 0");
  EXPECT_EQ(urdf.at("joint", "j", "axis/@xyz"), "0 0 1");
  EXPECT_EQ(urdf.at("joint", "j", "limit/@lower"), "-1");
  EXPECT_EQ(urdf.at("joint", "j", "limit/@upper"), "2");
  EXPECT_EQ(urdf.at("joint", "j", "limit/@effort"), "1e16");
  EXPECT_EQ(urdf.at("joint", "j", "dynamics/@damping"), "0.5");
  EXPECT_EQ(urdf.at("joint", "j", "dynamics/@friction"), "0.25");
  EXPECT_EQ(urdf.at("link", "arm", "visual/origin/@xyz"), "-0.1 0 0");
  EXPECT_EQ(urdf.at("link", "arm", "inertial/origin/@xyz"), "-0.1 0 0");
  EXPECT_EQ(urdf.against(), Names{});
  const FromMjcf sdf(text, ResultFormat::kSdf);
  EXPECT_EQ(sdf.at("joint", "j", "pose"), "0.1 0 0 0 0 0");
  EXPECT_EQ(sdf.at("link", "arm", "pose"), "1 0 0 0 0 0");
  EXPECT_EQ(sdf.at("link", "arm", "pose/@relative_to"), "base");
  EXPECT_EQ(sdf.at("joint", "j", "axis/dynamics/spring_stiffness"), "3");
  EXPECT_EQ(sdf.at("joint", "j", "axis/dynamics/spring_reference"), "0.5");
  EXPECT_EQ(sdf.against(), Names{});
}

/// m/12 (y² + z²) with full sides 0.2, 0.4, 0.6 and 2 kg.
TEST(FromMjcf, AGeomIsShapeColorAndWeight) {
  const FromMjcf urdf(body("base", ""), ResultFormat::kUrdf);
  EXPECT_EQ(urdf.at("link", "base", "collision/geometry/box/@size"), "0.2 0.4 0.6");
  EXPECT_EQ(urdf.at("link", "base", "inertial/mass/@value"), "2");
  EXPECT_NEAR(std::stod(urdf.at("link", "base", "inertial/inertia/@ixx")), 2 * 0.52 / 12, 1e-12);
  EXPECT_EQ(urdf.at("material", "color_1", "color/@rgba"), "0.5 0.5 0.5 1");
}

TEST(FromMjcf, LimitsCountFromRestAndInRadians) {
  const FromMjcf sdf("<mujoco><worldbody>" +
                         body("base", body("arm", "<joint name='j' ref='30' range='-60 90'/>")) +
                         "</worldbody></mujoco>",
                     ResultFormat::kSdf);
  const double degree = 3.14159265358979323846 / 180;
  EXPECT_NEAR(std::stod(sdf.at("joint", "j", "axis/limit/lower")), -90 * degree, 1e-12);
  EXPECT_NEAR(std::stod(sdf.at("joint", "j", "axis/limit/upper")), 60 * degree, 1e-12);
}

TEST(FromMjcf, SeveralJointsOfABodyAreARow) {
  const std::string text =
      body("base", body("arm", "<joint name='x' type='slide' axis='1 0 0'/><joint name='z'/>"));
  const FromMjcf urdf(text, ResultFormat::kUrdf);
  EXPECT_EQ(urdf.at("joint", "x", "@type"), "prismatic");
  EXPECT_EQ(urdf.at("joint", "x", "child/@link"), "arm_x");
  EXPECT_EQ(urdf.at("joint", "z", "parent/@link"), "arm_x");
  EXPECT_EQ(urdf.at("joint", "z", "@type"), "continuous");
  // What the link between weighs was taken from the arm.
  EXPECT_EQ(urdf.at("link", "arm_x", "inertial/mass/@value"), "2e-6");
  EXPECT_NEAR(std::stod(urdf.at("link", "arm", "inertial/mass/@value")), 2 - 2e-6, 1e-12);
  EXPECT_EQ(urdf.against(), Names{});
  EXPECT_EQ(FromMjcf(text, ResultFormat::kSdf).against(), Names{});
}

TEST(FromMjcf, ABallIsABallInSdfAndThreeJointsInUrdf) {
  const std::string text = body("base", body("arm", "<joint name='b' type='ball'/>"));
  const FromMjcf sdf(text, ResultFormat::kSdf);
  EXPECT_EQ(sdf.at("joint", "b", "@type"), "ball");
  EXPECT_EQ(sdf.against(), Names{});
  const FromMjcf urdf(text, ResultFormat::kUrdf);
  EXPECT_EQ(urdf.at("joint", "b_z", "axis/@xyz"), "0 0 1");
  EXPECT_EQ(urdf.at("joint", "b_x", "child/@link"), "arm");
  EXPECT_EQ(urdf.of_rule("convert-joint-type").size(), 1U);
  EXPECT_EQ(urdf.against(), Names{});
  const FromMjcf refused(text, ResultFormat::kUrdf, {}, {}, author::Losses::kRefused);
  EXPECT_EQ(refused.result.diagnostics.count(Severity::kError), 1U);
}

TEST(FromMjcf, JointsOfABallHaveNamesThatNoOtherHas) {
  const FromMjcf urdf(
      body("base", body("arm", "<joint name='b_z' type='slide'/><joint name='b' type='ball'/>")),
      ResultFormat::kUrdf);
  EXPECT_EQ(urdf.at("joint", "b_z", "@type"), "prismatic");
  EXPECT_EQ(urdf.at("joint", "b_z_2", "axis/@xyz"), "0 0 1");
  EXPECT_EQ(urdf.against(), Names{});
}

std::string finger(const std::string& sections) {
  return "<mujoco><compiler angle='radian'/><worldbody>" +
         body("base",
              body("a", "<joint name='lead'/>" + body("c", "<joint name='hand'/>", "pos='1 0 0'")) +
                  body("b", "<joint name='tail'/>", "pos='0 1 0'")) +
         "</worldbody>" + sections + "</mujoco>";
}

TEST(FromMjcf, AnEqualityOfJointsIsAMimic) {
  const std::string text =
      finger("<equality><joint joint1='tail' joint2='lead' polycoef='.1 -2 0 0 0'/></equality>");
  const FromMjcf urdf(text, ResultFormat::kUrdf);
  EXPECT_EQ(urdf.at("joint", "tail", "mimic/@joint"), "lead");
  EXPECT_EQ(urdf.at("joint", "tail", "mimic/@multiplier"), "-2");
  EXPECT_EQ(urdf.at("joint", "tail", "mimic/@offset"), "0.1");
  EXPECT_EQ(urdf.against(), Names{});
  const FromMjcf sdf(text, ResultFormat::kSdf);
  EXPECT_EQ(sdf.all("sdf").front().attribute("version")->value(), "1.11");
  EXPECT_EQ(sdf.at("joint", "tail", "axis/mimic/multiplier"), "-2");
  EXPECT_EQ(sdf.against(), Names{});
}

/// An anchor at (1, 1, 0) in the base is at (0, 1, 0) in `c`, which is at (1, 0, 0).
TEST(FromMjcf, AConnectClosesALoopInSdf) {
  const std::string text =
      finger("<equality><connect name='pin' body1='b' body2='c' anchor='1 0 0'/></equality>");
  const FromMjcf sdf(text, ResultFormat::kSdf);
  EXPECT_EQ(sdf.at("joint", "pin", "@type"), "ball");
  EXPECT_EQ(sdf.at("joint", "pin", "parent"), "b");
  EXPECT_EQ(sdf.at("joint", "pin", "child"), "c");
  EXPECT_EQ(sdf.at("joint", "pin", "pose"), "0 1 0 0 0 0");
  EXPECT_EQ(sdf.against(), Names{});
  const FromMjcf urdf(text, ResultFormat::kUrdf);
  EXPECT_EQ(urdf.of_rule("convert-from-mjcf-loop").size(), 1U);
  EXPECT_EQ(urdf.against(), Names{});
}

TEST(FromMjcf, AConstraintBetweenTwoTreesIsNoLoop) {
  const FromMjcf sdf("<mujoco><worldbody>" + body("a", "<freejoint/>") + body("b", "<freejoint/>") +
                         "</worldbody><equality><weld body1='a' body2='b'/></equality></mujoco>",
                     ResultFormat::kSdf);
  EXPECT_TRUE(sdf.all("joint").empty());
  EXPECT_EQ(sdf.of_rule("convert-from-mjcf-equality").size(), 1U);
  EXPECT_EQ(sdf.against(), Names{});
}

TEST(FromMjcf, TwoConnectsOnAnAxisAreAHinge) {
  const FromMjcf sdf(finger("<equality><connect body1='b' body2='c' anchor='1 0 0'/>"
                            "<connect body1='b' body2='c' anchor='1 0 .1'/></equality>"),
                     ResultFormat::kSdf);
  EXPECT_EQ(sdf.at("joint", "loop", "@type"), "revolute");
  EXPECT_EQ(sdf.at("joint", "loop", "axis/xyz"), "0 0 1");
  EXPECT_EQ(sdf.against(), Names{});
}

TEST(FromMjcf, WhatABallAndAFreeJointCannotHaveIsLost) {
  const std::string text =
      body("base", "<joint type='free' damping='0.1'/>" +
                       body("arm",
                            "<joint name='j' type='ball' damping='2' stiffness='3' "
                            "frictionloss='4' range='0 60'/>"));
  const FromMjcf sdf(text, ResultFormat::kSdf);
  EXPECT_EQ(sdf.of_rule("convert-from-mjcf-limit").size(), 5U);
  EXPECT_EQ(sdf.against(), Names{});
  // Each of the three joints has its damping.
  const FromMjcf urdf(text, ResultFormat::kUrdf);
  EXPECT_EQ(urdf.of_rule("convert-from-mjcf-limit").size(), 4U);
}

TEST(FromMjcf, AMissingIncludeIsRefused) {
  const FromMjcf sdf("<include file='none.xml'/>" + body("a", "<freejoint/>"), ResultFormat::kSdf);
  EXPECT_EQ(sdf.of_rule("convert-unresolved").size(), 1U);
  EXPECT_TRUE(sdf.all("link").empty());
}

TEST(FromMjcf, WhatOnlyOneSideOfAnActuatorHasIsSaid) {
  const auto said = [](const std::string& range) {
    const FromMjcf sdf("<mujoco><worldbody>" + body("a", "<joint name='j'/>") +
                           "</worldbody><actuator><motor name='m' joint='j' ctrllimited='true' "
                           "ctrlrange='" +
                           range + "'/></actuator></mujoco>",
                       ResultFormat::kSdf);
    return sdf.of_rule("convert-from-mjcf-actuator").size();
  };
  EXPECT_EQ(said("-1 1"), 0U);
  EXPECT_EQ(said("0 1"), 1U);
}

TEST(FromMjcf, AnActuatorLimitsTheEffort) {
  const FromMjcf urdf(finger("<actuator><motor joint='lead' gear='3' ctrlrange='-2 2'/>"
                             "<position joint='tail' kp='9' forcerange='-5 5'/></actuator>"),
                      ResultFormat::kUrdf);
  EXPECT_EQ(urdf.at("joint", "lead", "limit/@effort"), "6");
  EXPECT_EQ(urdf.at("joint", "tail", "limit/@effort"), "5");
  EXPECT_EQ(urdf.of_rule("convert-from-mjcf-actuator"),
            Names{"position/@kp is lost: only the effort limit of an actuator is in the result"});
}

TEST(FromMjcf, ASiteIsAFrameAndAnAccelerometerWithAGyroAnImu) {
  const FromMjcf sdf(
      "<mujoco><worldbody>" + body("base", "<freejoint/><site name='chip' pos='0 0 .1'/>") +
          "</worldbody><sensor><accelerometer site='chip'/><gyro site='chip'/></sensor></mujoco>",
      ResultFormat::kSdf);
  EXPECT_EQ(sdf.at("frame", "chip", "@attached_to"), "base");
  EXPECT_EQ(sdf.at("sensor", "chip", "@type"), "imu");
  EXPECT_EQ(sdf.at("sensor", "chip", "pose"), "0 0 0.1 0 0 0");
  EXPECT_EQ(sdf.against(), Names{});
}

TEST(FromMjcf, AForceIsWhatTheParentDoesToTheChild) {
  const FromMjcf sdf("<mujoco><worldbody>" +
                         body("base", body("arm", "<joint name='j'/><site name='s'/>")) +
                         "</worldbody><sensor><force site='s'/></sensor></mujoco>",
                     ResultFormat::kSdf);
  EXPECT_EQ(sdf.at("sensor", "s", "force_torque/measure_direction"), "parent_to_child");
}

// Of two bodies that rigor adds, or rounding of a center of mass, a proof makes nothing: 8000 kg against 1e-7 kg.
TEST(FromMjcf, WhatWeighsNextToNothingIsNoOtherRobot) {
  const FromMjcf sdf(
      "<geom type='box' size='1 1 1'/>" +
          std::string("<body pos='0 0 2'><freejoint/><geom type='box' size='1 1 1'/></body>"),
      ResultFormat::kSdf);
  EXPECT_EQ(sdf.against(), Names{});
}

TEST(FromMjcf, TorsionalFrictionIsLostWhereItIsNotMuJoCosOwn) {
  const auto said = [](const std::string& friction) {
    const FromMjcf sdf(
        "<body name='a'><freejoint/><geom size='1' friction='" + friction + "'/></body>",
        ResultFormat::kSdf);
    return sdf.of_rule("convert-from-mjcf-contact").size();
  };
  EXPECT_EQ(said("0.7"), 0U);
  EXPECT_EQ(said("0.7 0.005 0.0001"), 0U);
  EXPECT_EQ(said("0.7 0.3 0.0001"), 1U);
}

TEST(FromMjcf, AFloorIsALinkOfItsOwnInSdf) {
  const std::string text = "<geom name='floor' type='plane' size='5 4 .1'/>" +
                           body("base", "<freejoint/>", "pos='0 0 1'");
  const FromMjcf sdf(text, ResultFormat::kSdf);
  EXPECT_EQ(sdf.at("link", "surroundings", "collision/geometry/plane/size"), "10 8");
  EXPECT_EQ(sdf.at("joint", "surroundings_joint", "parent"), "world");
  EXPECT_EQ(sdf.against(), Names{});
  convert::FromMjcfOptions how;
  how.surroundings = convert::SurroundingsPolicy::kDrop;
  const FromMjcf bare(text, ResultFormat::kSdf, how);
  EXPECT_EQ(bare.all("link").size(), 1U);
  EXPECT_EQ(bare.against(), Names{});
  EXPECT_EQ(FromMjcf(text, ResultFormat::kUrdf).all("link").size(), 1U);
}

TEST(FromMjcf, BodiesThatMayTouchMakeTheModelCollideWithItself) {
  const auto text = [](const std::string& masks) {
    return "<mujoco><default><geom " + masks + "/></default><worldbody>" +
           body("a", body("b", "<joint/>" + body("c", "<joint/>"))) + "</worldbody></mujoco>";
  };
  EXPECT_EQ(FromMjcf(text(""), ResultFormat::kSdf).all("self_collide").size(), 1U);
  EXPECT_TRUE(FromMjcf(text("contype='2' conaffinity='1'"), ResultFormat::kSdf)
                  .all("self_collide")
                  .empty());
  // The one in the middle has neighbors alone.
  EXPECT_EQ(FromMjcf(text(""), ResultFormat::kUrdf).all("selfCollide").size(), 2U);
  EXPECT_TRUE(FromMjcf(text("contype='2' conaffinity='1'"), ResultFormat::kUrdf)
                  .all("selfCollide")
                  .empty());
}

TEST(FromMjcf, VerticesOfTheFileBecomeAMeshFile) {
  const std::string text =
      "<mujoco><asset><mesh name='tip' vertex='0 0 0 1 0 0 0 1 0 0 0 1'/></asset><worldbody>"
      "<body name='base'><geom type='mesh' mesh='tip' mass='1'/></body></worldbody></mujoco>";
  const FromMjcf sdf(text, ResultFormat::kSdf);
  ASSERT_EQ(sdf.result.files.size(), 1U);
  EXPECT_EQ(sdf.result.files[0].name, "meshes/tip.stl");
  EXPECT_EQ(sdf.result.files[0].bytes.size(), 84U + 4 * 50);  // a tetrahedron
  convert::FromMjcfOptions how;
  how.files = convert::FromMjcfFiles::kNone;
  EXPECT_EQ(FromMjcf(text, ResultFormat::kSdf, how).of_rule("convert-collision-lost").size(), 1U);
}

TEST(FromMjcf, EachMeshOfTheFileHasAFileOfItsOwn) {
  const std::string text =
      "<mujoco><asset><mesh name='one' vertex='0 0 0 1 0 0 0 1 0 0 0 1'/>"
      "<mesh name='two' vertex='0 0 0 1 0 0 0 1 0 0 0 2'/>"
      "<mesh name='again' vertex='0 0 0 1 0 0 0 1 0 0 0 1'/></asset><worldbody>"
      "<body name='base'><geom type='mesh' mesh='one' mass='1'/>"
      "<geom type='mesh' mesh='two' mass='1'/><geom type='mesh' mesh='again' mass='1'/>"
      "</body></worldbody></mujoco>";
  const FromMjcf sdf(text, ResultFormat::kSdf);
  ASSERT_EQ(sdf.result.files.size(), 2U);
  EXPECT_EQ(sdf.result.files[0].name, "meshes/one.stl");
  EXPECT_EQ(sdf.result.files[1].name, "meshes/two.stl");
  EXPECT_NE(sdf.result.files[0].bytes, sdf.result.files[1].bytes);
  std::map<std::string, int> uses;
  for (const xml::Element uri : sdf.all("uri")) ++uses[std::string(uri.text())];
  EXPECT_EQ(uses["meshes/one.stl"], 2 * uses["meshes/two.stl"]);

  const FromMjcf urdf(text, ResultFormat::kUrdf);
  EXPECT_EQ(urdf.result.files.size(), 2U);
  EXPECT_EQ(urdf.against(), Names{});
}

/// Each element and attribute has one outcome, those of included files too.
TEST(FromMjcf, TheAccountIsOverAllOfAllFiles) {
  const std::string text =
      "<mujoco model='m'><include file='more.xml'/><option timestep='.001'/>"
      "<default><default class='x'><joint armature='1' damping='2'/></default></default>"
      "<worldbody>" +
      body("base", "<freejoint/>" + body("arm",
                                         "<joint class='x' name='j' solreflimit='1 1'/>"
                                         "<plugin plugin='p'/><camera name='eye'/>")) +
      "</worldbody></mujoco>";
  for (const ResultFormat target : {ResultFormat::kUrdf, ResultFormat::kSdf}) {
    const FromMjcf made(text, target, {},
                        {{"in/more.xml",
                          "<mujoco><visual><map znear='1'/></visual><contact>"
                          "<exclude body1='base' body2='arm'/></contact></mujoco>"}});
    const auto& counts = made.result.account.counts;
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), made.nodes());
    EXPECT_EQ(made.of_rule("convert-from-mjcf-dynamics").size(), 2U);
    EXPECT_EQ(made.of_rule("convert-from-mjcf-contact").size(), 1U);
    EXPECT_EQ(made.of_rule("convert-from-mjcf-setting").size(), 1U);
    EXPECT_EQ(made.of_rule("convert-from-mjcf-not-carried").size(), 1U);
    EXPECT_EQ(made.against(), Names{});
  }
}

TEST(FromMjcf, NamesThatSdfHasOnceAreMadeDifferent) {
  const FromMjcf sdf(body("hip", body("leg", "<joint name='hip'/>")), ResultFormat::kSdf);
  EXPECT_EQ(sdf.at("joint", "hip_joint", "child"), "leg");
  EXPECT_EQ(sdf.against(), Names{});
}

/// Nobody takes a part of a robot for the robot.
TEST(FromMjcf, WhatIsNotReadToItsEndIsRefused) {
  for (const ResultFormat format : {ResultFormat::kUrdf, ResultFormat::kSdf}) {
    const FromMjcf result(
        "<replicate count='60000' offset='1 0 0'>" + body("b", "") + "</replicate>", format);
    EXPECT_FALSE(result.result.text);
    EXPECT_EQ(result.of_rule("convert-unresolved").size(), 1U);
  }
}

TEST(FromMjcf, OfAConstraintThatIsThereTheSoftnessIsLost) {
  const FromMjcf sdf("<mujoco><worldbody>" +
                         body("a", "<joint name='j'/>" + body("b", "<joint name='k'/>")) +
                         "</worldbody><equality><joint joint1='k' joint2='j' solref='.005 "
                         "1'/></equality></mujoco>",
                     ResultFormat::kSdf);
  EXPECT_EQ(sdf.of_rule("convert-from-mjcf-equality"), Names{});
  EXPECT_EQ(sdf.of_rule("convert-from-mjcf-dynamics"),
            Names{"joint/@solref is lost: the target has no such property of a joint"});
}

TEST(FromMjcf, AnActuatorOfATendonLimitsNothing) {
  const FromMjcf sdf(
      "<mujoco><worldbody>" + body("a", "<joint name='j'/>") +
          "</worldbody><tendon><fixed name='t'><joint joint='j' coef='1'/></fixed>"
          "</tendon><actuator><motor tendon='t' ctrlrange='-1 1'/></actuator></mujoco>",
      ResultFormat::kSdf);
  const Names found = sdf.of_rule("convert-from-mjcf-actuator");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("it gives no joint an effort limit"), std::string::npos) << found[0];
}

TEST(FromMjcf, NoiseAndCutoffOfASensorAreLost) {
  const FromMjcf sdf(
      "<mujoco><worldbody>" +
          body("a",
               "<freejoint/><site name='s'/><camera name='c' fovy='90' "
               "resolution='640 320'/>") +
          "</worldbody><sensor><gyro site='s' noise='.1' cutoff='3'/></sensor></mujoco>",
      ResultFormat::kSdf);
  const Names found = sdf.of_rule("convert-from-mjcf-sensor");
  const auto has = [&](const std::string& message) {
    return std::find(found.begin(), found.end(), message) != found.end();
  };
  EXPECT_TRUE(has("noise .1 of the gyro is lost"));
  EXPECT_TRUE(has("cutoff 3 of the gyro is lost"));
  EXPECT_EQ(sdf.all("width").at(0).text(), "640");
  EXPECT_EQ(sdf.all("height").at(0).text(), "320");
}

TEST(FromMjcf, AJointThatGetsAnotherNameIsAWarning) {
  const FromMjcf sdf(body("a", "<freejoint/>" + body("b", "<joint name='b'/>")),
                     ResultFormat::kSdf);
  EXPECT_EQ(sdf.of_rule("convert-from-mjcf-renamed"),
            Names{"joint b is named b_joint in the result"});
  const FromMjcf shapes(
      "<body name='a'><freejoint/><geom name='g' size='1'/><geom name='h' size='1' contype='0' "
      "conaffinity='0'/></body>",
      ResultFormat::kSdf);
  EXPECT_EQ(shapes.of_rule("convert-renamed"), Names{"g is named g_collision in the result"});
}

TEST(FromMjcf, AnInertialKeepsItsAxes) {
  const FromMjcf sdf(
      "<body name='rod'><freejoint/><inertial pos='0 0 1' euler='0 0.5 0' mass='0.4657' "
      "diaginertia='0.0038 0.0036 0.0002'/></body>",
      ResultFormat::kSdf);
  EXPECT_EQ(sdf.at("link", "rod", "inertial/pose"), "0 0 1 0 0.5 0");
  EXPECT_EQ(sdf.at("link", "rod", "inertial/inertia/ixx"), "0.0038");
  EXPECT_EQ(sdf.at("link", "rod", "inertial/inertia/izz"), "2e-04");
  EXPECT_EQ(sdf.against(), Names{});
}

TEST(FromMjcf, ABodyThatFloatsHasNoGravity) {
  const FromMjcf sdf(
      body("a", "<freejoint/>", "gravcomp='1'") + body("b", "<freejoint/>", "gravcomp='0.5'"),
      ResultFormat::kSdf);
  EXPECT_EQ(sdf.at("link", "a", "gravity"), "false");
  EXPECT_EQ(sdf.at("link", "b", "gravity"), "(none)");
}

TEST(FromMjcf, GravityOtherThanThatOfEarthIsAWarning) {
  const auto lost = [](const std::string& gravity) {
    return FromMjcf("<mujoco><option gravity='" + gravity + "' timestep='.001'/><worldbody>" +
                        body("a", "<freejoint/>") + "</worldbody></mujoco>",
                    ResultFormat::kSdf)
        .of_rule("convert-from-mjcf-gravity");
  };
  EXPECT_EQ(lost("0 0 -9.81"), Names{});
  EXPECT_EQ(lost("0 0 -1.62"),
            Names{"gravity 0 0 -1.62 is lost: it is the world's, not the model's"});
}

}  // namespace
}  // namespace rigor::test
