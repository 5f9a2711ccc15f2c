// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// MJCF files against what MuJoCo's documentation says of them, worked out by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include <rigor/mass/resolve.h>
#include <rigor/read/load.h>
#include <rigor/robot/robot.h>
#include <rigor/schema/embedded.h>

namespace rigor::read {
namespace {

constexpr double kPi = std::numbers::pi;

class MjcfFile {
 public:
  explicit MjcfFile(const std::string& text, std::map<std::string, std::string> beside = {})
      : disk_(with_main(std::move(beside), text)),
        resolver_(disk_, {}),
        sdf_(std::get<schema::Schema>(schema::Schema::parse(schema::sdf_schema_text()))),
        urdf_(std::get<schema::Schema>(schema::Schema::parse(schema::urdf_schema_text()))),
        workspace_(disk_, sources_),
        loaded_(load({workspace_, resolver_, sdf_, urdf_}, workspace_.open("model.xml"))),
        frames_(loaded_.root) {}

  const model::Root& root() const { return loaded_.root; }
  const model::Frames& frames() const { return frames_; }
  const MjcfFacts& facts() const { return loaded_.mjcf_facts; }

  model::Id<model::Link> link(const std::string& name) const {
    for (std::uint32_t i = 0; i < root().links.size(); ++i) {
      if (root().links[i].name.value == name) return {i};
    }
    ADD_FAILURE() << "no link " << name;
    return {0};
  }
  const model::Joint& joint(const std::string& name) const {
    for (const model::Joint& joint : root().joints) {
      if (joint.name.value == name) return joint;
    }
    ADD_FAILURE() << "no joint " << name;
    return root().joints.front();
  }
  mass::MassProperties mass(const std::string& name) const {
    return mass::resolve(root(), frames_, link(name), {}).body;
  }
  bool tells(MjcfFactKind kind) const {
    for (const MjcfFact& fact : facts()) {
      if (fact.kind == kind) return true;
    }
    return false;
  }

 private:
  static MemoryDisk with_main(std::map<std::string, std::string> files, const std::string& text) {
    files["model.xml"] = text;
    return MemoryDisk(std::move(files));
  }

  MemoryDisk disk_;
  Resolver resolver_;
  schema::Schema sdf_, urdf_;
  Sources sources_;
  Workspace workspace_;
  Loaded loaded_;
  model::Frames frames_;
};

void expect_near(const model::Vector3& found, const model::Vector3& expected) {
  EXPECT_NEAR(found.x, expected.x, 1e-12);
  EXPECT_NEAR(found.y, expected.y, 1e-12);
  EXPECT_NEAR(found.z, expected.z, 1e-12);
}

TEST(Mjcf, BodiesNestAndAnglesAreInDegrees) {
  const MjcfFile file(R"(<mujoco model="m"><worldbody>
    <body name="a" pos="1 0 0" euler="0 0 90"><joint name="j" range="-90 45"/><geom size="1"/>
      <body name="b" pos="1 0 0"><geom size="1"/></body></body></worldbody></mujoco>)");
  EXPECT_EQ(file.root().format, model::Format::kMjcf);
  // A turn by 90° about z takes the x axis of a to the y axis of the world.
  expect_near(file.frames().pose(file.link("b"))->translation, {1, 1, 0});
  const model::Axis& axis = file.joint("j").axes.front();
  EXPECT_NEAR(axis.lower.value, -kPi / 2, 1e-15);
  EXPECT_NEAR(axis.upper.value, kPi / 4, 1e-15);
  EXPECT_EQ(file.joint("b_fixed").type, model::JointType::kFixed);
}

TEST(Mjcf, RadiansAndSequencesOfTheCompilerHoldWhereverItIs) {
  const MjcfFile file(R"(<mujoco><worldbody>
    <body name="a" euler="1.5707963267948966 1.5707963267948966 0"><geom size="1"/>
      <body name="b" pos="0 0 1"><geom size="1"/></body></body></worldbody>
    <compiler angle="radian" eulerseq="XYZ"/></mujoco>)");
  // About the fixed x: z goes to -y; then about the fixed y it stays.
  expect_near(file.frames().pose(file.link("b"))->translation, {0, -1, 0});
}

TEST(Mjcf, OrientationsMeanTheSame) {
  for (const char* way :
       {R"(quat="0.7071067811865476 0 0 0.7071067811865476")", R"(axisangle="0 0 2 90")",
        R"(xyaxes="0 3 0 -1 1 0")", R"(euler="0 0 90")"}) {
    const MjcfFile file(
        std::string("<mujoco><worldbody><body name=\"a\" ") + way +
        R"(><geom size="1"/><body name="b" pos="1 2 3"><geom size="1"/></body></body>
                        </worldbody></mujoco>)");
    expect_near(file.frames().pose(file.link("b"))->translation, {-2, 1, 3});
  }
  const MjcfFile file(R"(<mujoco><worldbody><body name="a" zaxis="1 0 0"><geom size="1"/>
    <body name="b" pos="0 0 1"><geom size="1"/></body></body></worldbody></mujoco>)");
  expect_near(file.frames().pose(file.link("b"))->translation, {1, 0, 0});
}

TEST(Mjcf, ClassesNestAndTheNearestCounts) {
  const MjcfFile file(R"(<mujoco>
    <default><joint damping="1" armature="0.1"/>
      <default class="leg"><joint damping="2"/>
        <default class="foot"><joint frictionloss="3"/></default></default></default>
    <worldbody><body name="a" childclass="leg"><geom size="1"/><joint name="of_body"/>
      <body name="b"><geom size="1"/><joint name="own" class="foot"/></body>
      <body name="c"><geom size="1"/><joint name="main" class="main"/></body></body></worldbody></mujoco>)");
  EXPECT_EQ(file.joint("of_body").axes[0].damping.value, 2);
  EXPECT_EQ(file.joint("of_body").axes[0].armature.value, 0.1);
  EXPECT_EQ(file.joint("own").axes[0].damping.value, 2);
  EXPECT_EQ(file.joint("own").axes[0].friction.value, 3);
  EXPECT_EQ(file.joint("main").axes[0].damping.value, 1);
}

TEST(Mjcf, SeveralJointsOfABodyAreAChain) {
  const MjcfFile file(R"(<mujoco><worldbody><body name="a" pos="0 0 1">
    <joint name="slide" type="slide" axis="1 0 0"/><joint name="turn" axis="0 0 1" pos="0 1 0"/>
    <geom size="1"/></body></worldbody></mujoco>)");
  ASSERT_EQ(file.root().links.size(), 2U);
  EXPECT_TRUE(file.root().links[0].between_joints);
  EXPECT_EQ(file.mass("a_slide"), mass::MassProperties{});
  const robot::Robot robot = robot::robot_of(file.root(), file.frames(), {0});
  const auto X = robot::body_poses(robot, {{2}, {kPi / 2}});
  // Slid by 2, then turned by 90° about the point 0 1 0 of the body; the robot's body is at its joint.
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    if (robot.bodies[i].name != "a") continue;
    expect_near(X[i].translation, {2, 1, 1});
    expect_near(robot.bodies[i].mass.com, {0, -1, 0});
  }
}

TEST(Mjcf, PositionsAtRestAreZeroWhateverTheyAreCalled) {
  const MjcfFile file(R"(<mujoco><compiler angle="radian"/><worldbody><body name="a">
    <joint name="j" ref="0.5" range="0 2" springref="0.7" stiffness="3"/><geom size="1"/></body>
    </worldbody></mujoco>)");
  const model::Axis& axis = file.joint("j").axes.front();
  EXPECT_EQ(axis.position_at_rest, 0.5);
  EXPECT_EQ(axis.lower.value, -0.5);
  EXPECT_EQ(axis.upper.value, 1.5);
  EXPECT_NEAR(axis.spring_reference.value, 0.2, 1e-15);
}

TEST(Mjcf, SpringsTunedToATimeConstantAreOfTheInertiaOfTheirJoint) {
  const MjcfFile file(
      R"(<mujoco><worldbody><body><inertial mass="2" pos="0.5 0 0" diaginertia="1 1 1"/>
    <joint axis="0 1 0" springdamper="0.1 2" stiffness="7"/></body></worldbody></mujoco>)");
  const robot::Robot robot = robot::robot_of(file.root(), file.frames(), {0});
  const robot::Axis& axis = robot.joints[0].axes[0];
  // 1 + 2·0.5² kg·m². It swings with 1/(0.1·2) rad/s, twice as damped as it would have to be not to swing over.
  EXPECT_NEAR(std::sqrt(axis.spring_stiffness / 1.5), 5, 1e-12);
  EXPECT_NEAR(axis.damping / (2 * std::sqrt(axis.spring_stiffness * 1.5)), 2, 1e-12);
}

TEST(Mjcf, APrimitiveFittedToAMeshWeighsAsThatPrimitive) {
  const auto mass = [](const std::string& compiler) {
    const MjcfFile file("<mujoco>" + compiler + R"(<asset><mesh name="block"
        vertex="-1 -2 -3 1 -2 -3 -1 2 -3 1 2 -3 -1 -2 3 1 -2 3 -1 2 3 1 2 3"/></asset>
      <worldbody><body name="a"><geom type="sphere" mesh="block" density="1"/></body></worldbody></mujoco>)");
    return file.mass("a").mass;
  };
  EXPECT_NEAR(mass(""), 4 * kPi / 3 * 8, 1e-9);  // a sphere of 2 m
  // To bounds none is fitted: it counts as the mesh.
  EXPECT_NEAR(mass("<compiler fitaabb='true'/>"), 48, 1e-9);
}

TEST(Mjcf, LimitsCountWhereTheyAreSaid) {
  const std::string body = R"(<worldbody><body name="a"><joint name="j" type="slide" range="-1 1"/>
    <geom size="1"/></body></worldbody></mujoco>)";
  EXPECT_TRUE(MjcfFile("<mujoco>" + body).joint("j").axes[0].limit_written);
  const MjcfFile off(R"(<mujoco><compiler autolimits="false"/>)" + body);
  EXPECT_FALSE(off.joint("j").axes[0].limit_written);
  const auto limited = [](const std::string& attributes) {
    return MjcfFile("<mujoco><worldbody><body><joint name='j' " + attributes +
                    "/><geom size='1'/></body></worldbody></mujoco>")
        .joint("j")
        .axes[0]
        .limit_written;
  };
  EXPECT_FALSE(limited("range='1 -1'"));                // MuJoCo 3.14 takes it, and limits nothing
  EXPECT_TRUE(limited("range='1 -1' limited='true'"));  // which it rejects
  EXPECT_TRUE(std::isinf(off.joint("j").axes[0].upper.value));
}

TEST(Mjcf, GeomsWeighWhatTheirVolumesDo) {
  const MjcfFile file(R"(<mujoco><worldbody>
    <body name="ball"><freejoint/><geom size="0.1" density="2000"/></body>
    <body name="box"><freejoint/><geom type="box" size="0.1 0.2 0.3" mass="5" pos="1 0 0"/></body>
    <body name="rod"><freejoint/><geom type="capsule" size="0.1" fromto="0 0 0 0 0 1"/></body>
    <body name="shell"><freejoint/><geom size="0.5" mass="3" shellinertia="true"/></body>
    </worldbody></mujoco>)");
  EXPECT_NEAR(file.mass("ball").mass, 2000 * 4 * kPi * 0.001 / 3, 1e-12);
  const mass::MassProperties box = file.mass("box");
  EXPECT_NEAR(box.mass, 5, 1e-15);
  expect_near(box.com, {1, 0, 0});
  EXPECT_NEAR(box.about_com.ixx, 5 * (0.16 + 0.36) / 12, 1e-12);
  const mass::MassProperties rod = file.mass("rod");
  EXPECT_NEAR(rod.mass, 1000 * (kPi * 0.01 + 4 * kPi * 0.001 / 3), 1e-9);
  expect_near(rod.com, {0, 0, 0.5});
  EXPECT_NEAR(file.mass("shell").about_com.izz, 2 * 3 * 0.25 / 3, 1e-12);
}

TEST(Mjcf, InertialsGoBeforeGeomsUnlessTheCompilerSaysElse) {
  const std::string body = R"(<worldbody><body name="a"><freejoint/>
    <inertial pos="1 0 0" mass="7" diaginertia="1 2 2.5" euler="0 0 90"/>
    <geom size="0.1" mass="3"/></body></worldbody></mujoco>)";
  const mass::MassProperties written = MjcfFile("<mujoco>" + body).mass("a");
  EXPECT_EQ(written.mass, 7);
  EXPECT_NEAR(written.about_com.ixx, 2, 1e-12);  // the axes are turned by 90°
  EXPECT_NEAR(written.about_com.iyy, 1, 1e-12);
  const MjcfFile of_geoms(R"(<mujoco><compiler inertiafromgeom="true"/>)" + body);
  EXPECT_NEAR(of_geoms.mass("a").mass, 3, 1e-15);
}

TEST(Mjcf, TheCompilerScalesBalancesAndBounds) {
  const MjcfFile file(R"(<mujoco><compiler settotalmass="10"/><worldbody>
    <body name="a"><freejoint/><geom size="1" mass="1"/></body>
    <body name="b"><freejoint/><geom size="1" mass="3"/></body></worldbody></mujoco>)");
  EXPECT_NEAR(file.mass("a").mass, 2.5, 1e-12);
  EXPECT_NEAR(file.mass("b").about_com.ixx, 7.5 * 2 / 5, 1e-12);
  const MjcfFile balanced(R"(<mujoco><compiler balanceinertia="true" boundmass="2"/><worldbody>
    <body name="a"><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="1 1 7"/></body>
    </worldbody></mujoco>)");
  EXPECT_EQ(balanced.mass("a").mass, 2);
  EXPECT_NEAR(balanced.mass("a").about_com.izz, 3, 1e-12);
}

TEST(Mjcf, GeomsAreCollisionsVisualsOrBoth) {
  const MjcfFile file(R"(<mujoco><worldbody><body name="a">
    <geom name="both" size="1"/><geom name="seen" size="1" contype="0" conaffinity="0" rgba="1 0 0 1"/>
    <geom name="felt" size="1" group="3"/></body></worldbody></mujoco>)");
  const model::Link& link = file.root()[file.link("a")];
  ASSERT_EQ(link.collisions.size(), 2U);
  ASSERT_EQ(link.visuals.size(), 2U);
  EXPECT_EQ(file.root()[link.collisions[1]].name.value, "felt");
  EXPECT_EQ(file.root()[link.visuals[1]].name.value, "seen");
  EXPECT_EQ((*file.root()[link.visuals[1]].material.rgba)[0], 1);
  // Each weighs once.
  EXPECT_NEAR(file.mass("a").mass, 3 * 1000 * 4 * kPi / 3, 1e-6);
}

TEST(Mjcf, FramesAndCopiesPlaceWhatIsInThem) {
  const MjcfFile file(R"(<mujoco><worldbody>
    <frame pos="0 0 1" euler="0 0 90"><body name="a" pos="1 0 0"><geom size="1"/></body></frame>
    <replicate count="12" offset="0 1 0" sep="-"><body name="c"><geom size="0.1"/></body></replicate>
    </worldbody></mujoco>)");
  expect_near(file.frames().pose(file.link("a"))->translation, {0, 1, 1});
  expect_near(file.frames().pose(file.link("c-00"))->translation, {0, 0, 0});
  expect_near(file.frames().pose(file.link("c-11"))->translation, {0, 11, 0});
}

TEST(Mjcf, FilesAreIncludedFromTheFolderOfTheMainOne) {
  const std::string body = R"(<worldbody><body name="a"><geom size="1"/></body></worldbody>)";
  const MjcfFile file(
      R"(<mujoco><include file="parts/world.xml"/></mujoco>)",
      {{"parts/world.xml", R"(<mujocoinclude><include file="parts/a.xml"/></mujocoinclude>)"},
       {"parts/a.xml", "<mujoco>" + body + "</mujoco>"}});
  EXPECT_EQ(file.root().links.size(), 1U);
  EXPECT_TRUE(file.facts().empty());
}

TEST(Mjcf, OtherModelsAreAttachedWithTheirOwnUnits) {
  const MjcfFile file(R"(<mujoco><compiler angle="radian"/>
    <asset><model name="hand" file="hand.xml"/></asset>
    <worldbody><body name="arm" pos="0 0 1"><geom size="1"/>
      <attach model="hand" body="palm" prefix="left_"/></body></worldbody></mujoco>)",
                      {{"hand.xml", R"(<mujoco><worldbody><body name="palm" pos="0 0 1">
    <joint name="j" range="0 180"/><geom size="1"/></body></worldbody></mujoco>)"}});
  expect_near(file.frames().pose(file.link("left_palm"))->translation, {0, 0, 2});
  EXPECT_NEAR(file.joint("left_j").axes[0].upper.value, kPi, 1e-15);
}

TEST(Mjcf, EqualitiesAreMimicsAndActuatorsEfforts) {
  const MjcfFile file(R"(<mujoco><worldbody>
    <body name="a"><joint name="j"/><geom size="1"/></body>
    <body name="b"><joint name="k"/><geom size="1"/></body></worldbody>
    <equality><joint joint1="k" joint2="j" polycoef="0.5 -2 0 0 0"/></equality>
    <actuator><motor joint="j" gear="10" ctrlrange="-2 2"/><position joint="k" forcerange="-4 5"/></actuator>
    </mujoco>)");
  ASSERT_TRUE(file.joint("k").axes[0].mimic);
  EXPECT_EQ(file.joint("k").axes[0].mimic->multiplier.value, -2);
  EXPECT_EQ(file.joint("k").axes[0].mimic->offset.value, 0.5);
  EXPECT_EQ(file.joint("j").axes[0].effort.value, 20);
  EXPECT_EQ(file.joint("k").axes[0].effort.value, 5);
}

TEST(Mjcf, AFreeBodyIsARootOfTheRobot) {
  const MjcfFile file(R"(<mujoco><worldbody><body name="a" pos="0 0 3"><freejoint name="f"/>
    <geom size="1"/></body></worldbody></mujoco>)");
  EXPECT_EQ(file.joint("f").type, model::JointType::kFloating);
  const robot::Robot robot = robot::robot_of(file.root(), file.frames(), {0});
  ASSERT_EQ(robot.bodies.size(), 1U);
  EXPECT_TRUE(robot.joints.empty());
}

TEST(Mjcf, MeshesAreFoundWhereTheCompilerSays) {
  const MjcfFile file(R"(<mujoco><compiler meshdir="meshes"/>
    <asset><mesh file="sub/part.stl" scale="2 2 2" refpos="1 0 0"/></asset>
    <worldbody><body name="a"><geom type="mesh" mesh="part" pos="0 0 5" mass="1"/></body></worldbody>
    </mujoco>)",
                      {{"meshes/sub/part.stl", ""}});
  const auto& link = file.root()[file.link("a")];
  const auto& visual = file.root()[link.visuals.at(0)];
  EXPECT_EQ(std::get<model::Mesh>(visual.geometry.shape).uri.value, "meshes/sub/part.stl");
  // The reference point is taken from the vertices before they are scaled.
  expect_near(visual.pose.pose.value.translation, {-2, 0, 5});
  EXPECT_FALSE(file.tells(MjcfFactKind::kAssetMissing));
}

TEST(Mjcf, IncludesThatNestAreBounded) {
  std::string open, close;
  for (int i = 0; i < 60; ++i) {
    open += "<body><geom size='1'/>";
    close += "</body>";
  }
  const auto nested = [&](int file) {
    return open + "<include file='" + std::to_string(file) + ".xml'/>" + close;
  };
  std::map<std::string, std::string> files;
  for (int i = 0; i < 900; ++i) {
    files[std::to_string(i) + ".xml"] = "<mujoco>" + nested(i + 1) + "</mujoco>";
  }
  const MjcfFile file("<mujoco><worldbody>" + nested(0) + "</worldbody></mujoco>", files);
  EXPECT_TRUE(file.tells(MjcfFactKind::kIncludeBroken));
  EXPECT_EQ(file.root().links.size(), 120U);
}

TEST(Mjcf, CopiesThatMultiplyAreBounded) {
  std::string open, close;
  for (int i = 0; i < 6; ++i) {
    open += R"(<replicate count="1000" offset="0 0 1">)";
    close += "</replicate>";
  }
  const MjcfFile file("<mujoco><worldbody>" + open +
                      R"(<geom size="1" contype="0" conaffinity="0"/>)" + close +
                      "</worldbody></mujoco>");
  EXPECT_LE(file.root().visuals.size(), 200'010U);
  EXPECT_TRUE(file.tells(MjcfFactKind::kTooLarge));
  EXPECT_TRUE(file.root().cut.written);
}

/// What is left out is never left out in silence.
TEST(Mjcf, WhatIsTooLargeIsReportedOnce) {
  const auto copies = [](const std::string& count, const std::string& inside) {
    return MjcfFile("<mujoco><worldbody><replicate count='" + count + "' offset='1 0 0'>" + inside +
                    "</replicate></worldbody></mujoco>");
  };
  const std::string body = "<body><geom size='.1' mass='1'/></body>";
  EXPECT_FALSE(copies("2000", body).root().cut.written);
  EXPECT_EQ(copies("2000", body).root().links.size(), 2000U);
  for (const char* count : {"60000", "100001", "1e15"}) {
    const MjcfFile file = copies(count, body);
    EXPECT_TRUE(file.root().cut.written) << count;
    EXPECT_EQ(
        std::count_if(file.facts().begin(), file.facts().end(),
                      [](const MjcfFact& fact) { return fact.kind == MjcfFactKind::kTooLarge; }),
        1)
        << count;
  }
}

/// Elements that become nothing cost time all the same: thirty tens are 10³⁰ visits.
TEST(Mjcf, VisitsAreBoundedWhateverComesOfThem) {
  for (const char* inside : {"<geom size='1'/>", "<light/>", ""}) {
    std::string open, close;
    for (int i = 0; i < 30; ++i) {
      open += "<replicate count='10' offset='1 0 0'>";
      close += "</replicate>";
    }
    const MjcfFile file("<mujoco><worldbody>" + open + inside + close + "</worldbody></mujoco>");
    EXPECT_TRUE(file.root().cut.written) << inside;
  }
}

TEST(Mjcf, JointsAndSitesCountAsWell) {
  for (const char* inside : {"<joint/>", "<site name='s'/>", "<geom size='1'/>"}) {
    const MjcfFile file(std::string("<mujoco><worldbody><body><replicate count='100000'>"
                                    "<replicate count='1000'>") +
                        inside + "</replicate></replicate></body></worldbody></mujoco>");
    EXPECT_TRUE(file.root().cut.written) << inside;
    EXPECT_LE(file.root().joints.size() + file.root().frames.size(), 200'010U);
  }
}

/// A name of a megabyte, and as many copies of it.
TEST(Mjcf, NamesOfCopiesAreBounded) {
  const MjcfFile file("<mujoco><worldbody><replicate count='5000' sep='" +
                      std::string(1'000'000, 's') +
                      "'><body name='b'/></replicate></worldbody></mujoco>");
  EXPECT_TRUE(file.root().cut.written);
  EXPECT_LE(file.root().links.size(), 100U);
}

TEST(Mjcf, ModelsThatAttachThemselvesAreBounded) {
  std::string open, close;
  for (int i = 0; i < 40; ++i) {
    open += "<body>";
    close += "</body>";
  }
  const MjcfFile file("<mujoco><worldbody><body name='b'>" + open +
                      "<attach prefix='a' body='b'/>" + close + "</body></worldbody></mujoco>");
  EXPECT_TRUE(file.root().cut.written);
}

TEST(Mjcf, ATotalMassIsSharedByNoMoreBodiesThanCanBeSummedForEach) {
  const auto file = [](const std::string& count) {
    return MjcfFile(
        "<mujoco><compiler settotalmass='1'/><worldbody><replicate count='" + count +
        "' offset='1 0 0'><body><geom size='.1'/></body></replicate></worldbody></mujoco>");
  };
  EXPECT_FALSE(file("100").root().cut.written);
  EXPECT_TRUE(file("4000").root().cut.written);
}

TEST(Mjcf, ManySitesOfOneNameAreNamedQuickly) {
  std::string sites;
  for (int i = 0; i < 30'000; ++i) sites += "<site name='b'/>";
  const MjcfFile file("<mujoco><worldbody><body name='b'><geom size='1'/>" + sites +
                      "</body></worldbody></mujoco>");
  ASSERT_EQ(file.root().frames.size(), 30'000U);
  EXPECT_EQ(file.root().frames[0].name.value, "b_site");
  EXPECT_EQ(file.root().frames[1].name.value, "b_site_2");
}

TEST(Mjcf, NumbersThatAnElementDoesNotGiveAreThoseOfItsClass) {
  const MjcfFile file(R"(<mujoco>
    <default><geom type="capsule" size="0.05 0.2" friction="2 3 4"/>
      <default class="x"><geom size="0.07"/></default></default>
    <worldbody><body name="a"><freejoint/><geom size="0.04"/></body>
      <body name="b"><freejoint/><geom class="x"/></body>
      <body name="c"><joint name="j"/><geom/></body>
      <body name="d"><joint name="k"/><geom/></body></worldbody>
    <equality><joint joint1="j" joint2="k" polycoef="0.5"/></equality></mujoco>)");
  const auto shape = [&](const char* body) {
    const model::Link& link = file.root()[file.link(body)];
    return std::get<model::Capsule>(file.root()[link.collisions.at(0)].geometry.shape);
  };
  EXPECT_EQ(shape("a").radius.value, 0.04);
  EXPECT_EQ(shape("a").length.value, 0.4);
  EXPECT_EQ(shape("b").radius.value, 0.07);
  EXPECT_EQ(shape("b").length.value, 0.4);
  EXPECT_FALSE(file.tells(MjcfFactKind::kSizeMissing));
  EXPECT_EQ(file.joint("j").axes[0].mimic->multiplier.value, 1);  // MuJoCo's own
}

/// MuJoCo 3.14 has the same for these corners of 2 m × 4 m × 6 m.
TEST(Mjcf, AShellWeighsAsItsSurface) {
  const auto file = [](const std::string& attributes) {
    return MjcfFile(R"(<mujoco><asset><mesh name="block" inertia="shell"
        vertex="-1 -2 -3 1 -2 -3 -1 2 -3 1 2 -3 -1 -2 3 1 -2 3 -1 2 3 1 2 3"/></asset>
      <worldbody><body name="a"><geom type="mesh" mesh="block" )" +
                    attributes + "/></body></worldbody></mujoco>");
  };
  const mass::MassProperties body = file("").mass("a");
  EXPECT_NEAR(body.mass, 88'000, 1e-6);
  EXPECT_NEAR(body.about_com.ixx, 541'333.3333333334, 1e-6);
  EXPECT_NEAR(body.about_com.izz, 242'666.6666666667, 1e-6);
  EXPECT_NEAR(file("mass='2'").mass("a").about_com.izz, 2 * 242'666.6666666667 / 88'000, 1e-9);
}

/// Numbers of MuJoCo 3.14.
TEST(Mjcf, AMeshIsRotatedBeforeItIsScaled) {
  const auto mass = [](const std::string& attributes) {
    return MjcfFile(R"(<mujoco><asset><mesh name="block" inertia="exact"
        vertex="-1 -2 -3 1 -2 -3 -1 2 -3 1 2 -3 -1 -2 3 1 -2 3 -1 2 3 1 2 3" scale="1 2 3" )" +
                    attributes + R"(/></asset>
      <worldbody><body name="a"><geom type="mesh" mesh="block"/></body></worldbody></mujoco>)")
        .mass("a");
  };
  const auto quarter = mass("refpos='1 0 0' refquat='0.7071067811865476 0 0 0.7071067811865476'");
  EXPECT_NEAR(quarter.mass, 288'000, 1e-6);
  expect_near(quarter.com, {0, 2, 0});
  EXPECT_NEAR(quarter.about_com.ixx, 8'160'000, 1e-3);
  EXPECT_NEAR(quarter.about_com.izz, 768'000, 1e-3);
  const auto eighth = mass("refquat='0.9238795325112867 0 0 0.3826834323650898'");
  EXPECT_NEAR(eighth.about_com.ixx + eighth.about_com.iyy, 8'837'024.945 + 7'914'975.055, 1);
  EXPECT_NEAR(eighth.about_com.izz, 1'200'000, 1e-3);
}

TEST(Mjcf, AMeshFileThatIsShearedIsReported) {
  const MjcfFile file(R"(<mujoco><asset><mesh name="m" file="m.stl" scale="1 2 3"
      refquat="0.9238795 0 0 0.3826834"/></asset></mujoco>)",
                      {{"m.stl", ""}});
  EXPECT_TRUE(file.tells(MjcfFactKind::kMeshSheared));
}

/// MuJoCo takes the last.
TEST(Mjcf, AnInertialMayBeInAFrame) {
  const MjcfFile file(R"(<mujoco><worldbody><body name="a"><freejoint/>
    <frame pos="1 0 0" euler="0 0 90"><inertial pos="1 0 0" mass="2" diaginertia="1 2 2.5"/></frame>
    </body></worldbody></mujoco>)");
  const mass::MassProperties body = file.mass("a");
  EXPECT_EQ(body.mass, 2);
  expect_near(body.com, {1, 1, 0});
  EXPECT_NEAR(body.about_com.ixx, 2, 1e-12);
  const MjcfFile two(R"(<mujoco><worldbody><body name="a"><freejoint/>
    <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
    <frame pos="1 0 0"><inertial pos="0 0 0" mass="2" diaginertia="1 1 1"/></frame>
    </body></worldbody></mujoco>)");
  EXPECT_EQ(two.mass("a").mass, 2);
}

TEST(Mjcf, TheWholeWorldOfAnotherModelCanBeAttached) {
  const MjcfFile file(R"(<mujoco><asset><model name="m" file="m.xml"/></asset>
    <worldbody><attach model="m" body="world" prefix="p_"/></worldbody></mujoco>)",
                      {{"m.xml", R"(<mujoco><worldbody><body name="a"><geom size="1"/></body>
      </worldbody></mujoco>)"}});
  EXPECT_FALSE(file.tells(MjcfFactKind::kReferenceMissing));
  file.link("p_a");
}

}  // namespace
}  // namespace rigor::read
