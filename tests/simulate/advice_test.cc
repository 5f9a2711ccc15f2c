// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/advice/advice.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>
#include <rigor/simulate/advice/parts.h>
#include <rigor/simulate/scene/input.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>

#include "simulate/hand_robot.h"
#include "simulate/hand_scene.h"

namespace rigor {
namespace {

using namespace simulate;
using hand::tutorial_robot;

/// Input of a file with nothing in it, for causes that look at the scene only.
struct NoFile {
  RealDisk disk;
  Environment environment{disk, {}};
  Sources sources;
  read::Workspace workspace{disk, sources};
  read::Loaded loaded;
  SceneFiles files;

  explicit NoFile(const std::string& path = "testdata/none.sdf")
      : loaded(read::load({workspace, environment.resolver, environment.sdf, environment.urdf},
                          workspace.open(path))),
        files(loaded, workspace, environment.resolver, environment.workers) {}
};

std::vector<Fact> of_kind(const Facts& facts, FactKind kind) {
  std::vector<Fact> some;
  for (const Fact& fact : facts) {
    if (fact.kind == kind) some.push_back(fact);
  }
  return some;
}

Facts causes_of(const Scene& scene) {
  const NoFile none;
  return causes_in(scene, none.files.input(), find_wheels(scene, {}));
}

TEST(Advice, TheTutorialRobotsWheelsHave200TimesTheInertiaOfTheirShape) {
  const NoFile file(std::string(RIGOR_TESTDATA) + "models/my_robot/model.sdf");
  const SceneResult made = build_scene(file.files.input(), {});
  ASSERT_FALSE(made.blocked());
  const Facts causes = causes_in(made.scene, file.files.input(), find_wheels(made.scene, {}));
  const std::vector<Fact> inertias = of_kind(causes, FactKind::kCauseDefaultInertia);
  ASSERT_EQ(inertias.size(), 3U);
  // 1 kg m² against 1 kg (0.1 m)²/2.
  const auto wheel = std::find_if(inertias.begin(), inertias.end(), [](const Fact& fact) {
    return fact.subject == "my_robot/link left_wheel";
  });
  ASSERT_NE(wheel, inertias.end());
  EXPECT_NEAR(wheel->value, 200, 0.01);
  EXPECT_FALSE(wheel->where.nowhere());
  const Facts behind = explain({.kind = FactKind::kDriveBackwards}, causes);
  ASSERT_FALSE(behind.empty());
  EXPECT_EQ(behind[0].kind, FactKind::kCauseDefaultInertia);
}

/// A link without shapes may be a frame; of one whose mesh is missing nobody knows.
TEST(Advice, ALinkWhoseMeshIsMissingIsNoFrame) {
  const std::string path = testing::TempDir() + "rigor_advice_lost_mesh.sdf";
  const auto help = [&](const std::string& shape) {
    std::ofstream(path) << "<sdf version='1.9'><model name='m'><link name='a'>" + shape +
                               "</link></model></sdf>";
    const NoFile file(path);
    const Scene scene = build_scene(file.files.input(), {}).scene;
    const Facts causes = causes_in(scene, file.files.input(), {});
    const std::vector<Fact> inertias = of_kind(causes, FactKind::kCauseDefaultInertia);
    return inertias.empty() ? std::string() : inertias[0].help;
  };
  EXPECT_EQ(help(""), "replace the link with a `<frame>`, or give it a small `<inertial>`");
  EXPECT_EQ(
      help("<collision name='c'><geometry><mesh><uri>lost.stl</uri></mesh></geometry></collision>"),
      "give it an `<inertial>`");
  std::filesystem::remove(path);
}

/// "no inertial" is not true of one that has a mass.
TEST(Advice, AMassWithoutATensorIsAKindOfItsOwn) {
  const std::string path = testing::TempDir() + "rigor_advice_mass_alone.sdf";
  std::ofstream(path)
      << "<sdf version='1.9'><model name='m'><link name='a'><inertial><mass>5</mass>"
         "</inertial><collision name='c'><geometry><sphere><radius>0.1</radius>"
         "</sphere></geometry></collision></link></model></sdf>";
  const NoFile file(path);
  const Scene scene = build_scene(file.files.input(), {}).scene;
  const Facts causes = causes_in(scene, file.files.input(), {});
  EXPECT_TRUE(of_kind(causes, FactKind::kCauseDefaultInertia).empty());
  const std::vector<Fact> inertias = of_kind(causes, FactKind::kCauseInertiaNotWritten);
  ASSERT_EQ(inertias.size(), 1U);
  EXPECT_NEAR(inertias[0].value, 1 / (0.4 * 5 * 0.01), 1e-9);
  // It explains what the default explains.
  ASSERT_FALSE(explain({.kind = FactKind::kDriveBackwards}, causes).empty());
  std::filesystem::remove(path);
}

TEST(Advice, NothingIsWrongWithAGoodRobot) { EXPECT_TRUE(causes_of(tutorial_robot()).empty()); }

TEST(Advice, AWheelOffCenterTiltedOrReversed) {
  Scene scene = tutorial_robot();
  scene.shapes[2].X_BS.translation = {0.004, 0, 0};
  scene.shapes[3].X_BS.rotation = model::from_rpy(0.05, 0, 0);
  scene.joints[1].axes[0].direction_W = {0, -1, 0};
  const Facts causes = causes_of(scene);
  const std::vector<Fact> off = of_kind(causes, FactKind::kCauseWheelOffCenter);
  ASSERT_EQ(off.size(), 1U);
  EXPECT_NEAR(off[0].value, 0.004, 1e-12);
  EXPECT_EQ(off[0].subject, "my_robot/joint left_wheel_hinge");
  EXPECT_TRUE(off[0].severe);
  const std::vector<Fact> axes = of_kind(causes, FactKind::kCauseWheelAxis);
  ASSERT_EQ(axes.size(), 2U);
  for (const Fact& axis : axes) {
    EXPECT_EQ(axis.subject, "my_robot/joint right_wheel_hinge");
    EXPECT_NEAR(axis.value, axis.name == "tilted" ? 0.05 : -1, 1e-9);
  }
}

TEST(Advice, ACasterThatGrips) {
  Scene scene = tutorial_robot();
  scene.shapes[1].surface.mu = 0.8;
  const std::vector<Fact> casters = of_kind(causes_of(scene), FactKind::kCauseCasterFriction);
  ASSERT_EQ(casters.size(), 1U);
  EXPECT_EQ(casters[0].value, 0.8);
}

/// A cart's front wheel that a universal joint steers and rolls is no caster, whatever its friction.
TEST(Advice, ASteeredWheelThatRollsIsNoCaster) {
  Scene scene = tutorial_robot();
  hand::add_body(scene, hand::drum_mass(0.5, 0.05, 0.02), {-0.15, 0, 0.05},
                 model::from_rpy(std::numbers::pi / 2, 0, 0));
  scene.shapes.erase(scene.shapes.begin() + 1);
  hand::add_shape(scene, 3, mesh::Cylinder{0.05, 0.02});
  hand::add_joint(scene, model::JointType::kUniversal, 0, 3, {-0.15, 0, 0.05},
                  {{0, 0, 1}, {0, 1, 0}});
  EXPECT_TRUE(of_kind(causes_of(scene), FactKind::kCauseCasterFriction).empty());
  scene.joints.back().axes[1].direction_W = {1, 0, 0};  // about which it does not roll
  EXPECT_EQ(of_kind(causes_of(scene), FactKind::kCauseCasterFriction).size(), 1U);
}

/// TurtleBot3's base_footprint: a frame that was written as a link, 60 times as hard to turn as the robot of 1 kg.
TEST(Advice, AFrameThatIsALinkHasTheDefaultInertia) {
  const auto defaults = [](const std::string& marker) {
    const MemoryDisk disk(
        {{"a.sdf",
          "<sdf version='1.9'><model name='m'><link name='body'><inertial><mass>1</mass>"
          "<inertia><ixx>0.007</ixx><iyy>0.007</iyy><izz>0.007</izz></inertia></inertial>"
          "<collision name='c'><geometry><box><size>0.2 0.2 0.2</size></box></geometry>"
          "</collision></link>" +
              marker +
              "<joint name='j' type='fixed'><parent>body</parent>"
              "<child>marker</child></joint></model></sdf>"}});
    const Environment environment(disk, {});
    Sources sources;
    read::Workspace workspace(disk, sources);
    const read::Loaded loaded =
        read::load({workspace, environment.resolver, environment.sdf, environment.urdf},
                   workspace.open("a.sdf"));
    const SceneFiles files(loaded, workspace, environment.resolver, environment.workers);
    const SceneResult made = build_scene(files.input(), {});
    return of_kind(causes_in(made.scene, files.input(), {}), FactKind::kCauseDefaultInertia);
  };
  const std::vector<Fact> found = defaults("<link name='marker'/>");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].subject, "m/link marker");
  EXPECT_TRUE(found[0].severe);
  EXPECT_NE(found[0].help.find("<frame>"), std::string::npos);
  EXPECT_TRUE(defaults("<link name='marker'><inertial><mass>0.01</mass><inertia><ixx>1e-6</ixx>"
                       "<iyy>1e-6</iyy><izz>1e-6</izz></inertia></inertial></link>")
                  .empty());
}

TEST(Advice, AWheelWithoutFrictionOrSmallerThanTheOther) {
  Scene scene = tutorial_robot();
  scene.shapes[2].surface.mu = 0.02;
  EXPECT_TRUE(of_kind(causes_of(scene), FactKind::kCauseWheelFriction).empty());  // mu2 grips
  scene.shapes[2].surface.mu2 = 0;
  scene.shapes[3].kind = mesh::Cylinder{0.095, 0.05};
  const Facts causes = causes_of(scene);
  const std::vector<Fact> slippery = of_kind(causes, FactKind::kCauseWheelFriction);
  ASSERT_EQ(slippery.size(), 1U);
  EXPECT_EQ(slippery[0].subject, "collision shape 2");
  EXPECT_EQ(slippery[0].value, 0.02);
  EXPECT_FALSE(slippery[0].severe);  // a plugin may move it
  const std::vector<Fact> radii = of_kind(causes, FactKind::kCauseWheelRadii);
  ASSERT_EQ(radii.size(), 1U);
  EXPECT_EQ(radii[0].subject, "collision shape 3");
  EXPECT_NEAR(radii[0].value, 0.095, 1e-12);
  EXPECT_NEAR(radii[0].limit, 0.1, 1e-12);
  EXPECT_EQ(explain({.kind = FactKind::kDriveSlips}, causes)[0].kind,
            FactKind::kCauseWheelFriction);
}

/// Why a wheel falls through the ground.
TEST(Advice, AShapeWhoseMaxContactsAreZeroTouchesNothing) {
  Scene scene = tutorial_robot();
  const auto wheel = std::find_if(scene.shapes.begin(), scene.shapes.end(),
                                  [](const SceneShape& shape) { return shape.body == 1; });
  wheel->surface.max_contacts = 0;
  const Facts causes = causes_of(scene);
  const std::vector<Fact> flags = of_kind(causes, FactKind::kCauseFlag);
  ASSERT_EQ(flags.size(), 1U);
  EXPECT_EQ(flags[0].name, "max_contacts");
  EXPECT_EQ(explain({.kind = FactKind::kFalls}, causes)[0].kind, FactKind::kCauseFlag);
}

TEST(Advice, ALinkThatIsKinematicOrWithoutGravity) {
  Scene scene = tutorial_robot();
  scene.bodies[0].kinematic = true;
  scene.bodies[1].gravity = false;
  scene.bodies[2].gravity = false;
  scene.bodies[2].mass.mass = 0.02;  // of 5.52 kg: nobody misses it
  const std::vector<Fact> flags = of_kind(causes_of(scene), FactKind::kCauseFlag);
  ASSERT_EQ(flags.size(), 2U);
  EXPECT_EQ(flags[0].subject, "my_robot/link chassis");
  EXPECT_EQ(flags[0].name, "kinematic");
  EXPECT_EQ(flags[1].subject, "my_robot/link left_wheel");
  EXPECT_EQ(flags[1].name, "gravity");
  for (SceneBody& body : scene.bodies) body = {.mass = body.mass, .gravity = false, .model = 0};
  const std::vector<Fact> floats = of_kind(causes_of(scene), FactKind::kCauseFlag);
  ASSERT_EQ(floats.size(), 3U);
  EXPECT_EQ(floats[0].name, "no gravity");
}

/// A crate of 10 kg on its four corners sinks by m g / 4 kp.
TEST(Advice, ContactsTooSoftForTheWeight) {
  Scene scene;
  scene.models.push_back({.name = "crate", .base = 0});
  SceneBody body;
  body.name = "crate::body";
  body.X_WB.translation = {0, 0, 0.5};
  body.mass = {10, {}, {1, 0, 0, 1, 0, 1}};
  scene.bodies = {body};
  scene.shapes = {hand::shape_of(0, mesh::Box{{1, 1, 1}})};
  scene.shapes[0].surface.kp = 1000;
  const std::vector<Fact> soft = of_kind(causes_of(scene), FactKind::kCauseSoftContact);
  ASSERT_EQ(soft.size(), 1U);
  EXPECT_NEAR(soft[0].value, 10 * 9.8 / 4000, 1e-12);
  EXPECT_TRUE(soft[0].severe);
  scene.shapes[0].surface.kp = 1e4;  // 2.5 mm
  EXPECT_TRUE(of_kind(causes_of(scene), FactKind::kCauseSoftContact).empty());
}

TEST(Advice, MassesThatDifferByMoreThanAHundred) {
  Scene scene = tutorial_robot();
  scene.bodies[1].mass = hand::cylinder_mass(0.04, 0.1, 0.05);  // 125 times lighter
  const std::vector<Fact> ratios = of_kind(causes_of(scene), FactKind::kCauseMassRatio);
  ASSERT_EQ(ratios.size(), 1U);
  EXPECT_NEAR(ratios[0].value, 125, 1e-9);
  EXPECT_EQ(ratios[0].subject, "my_robot/link left_wheel");
  EXPECT_EQ(ratios[0].name, "my_robot/link chassis");
}

TEST(Advice, ATowerIsTopHeavy) {
  Scene scene;
  scene.models.push_back({.name = "tower", .base = 0});
  SceneBody body;
  body.name = "tower::body";
  body.X_WB.translation = {0, 0, 1};
  body.mass = {10, {}, {1, 0, 0, 1, 0, 1}};
  scene.bodies = {body};
  scene.shapes = {hand::shape_of(0, mesh::Box{{0.2, 0.2, 2}})};
  const std::vector<Fact> heavy = of_kind(causes_of(scene), FactKind::kCauseTopHeavy);
  ASSERT_EQ(heavy.size(), 1U);
  EXPECT_NEAR(heavy[0].value, std::atan2(0.1, 1), 1e-9);
  scene.shapes.clear();
  EXPECT_EQ(of_kind(causes_of(scene), FactKind::kCauseNoCollision).size(), 1U);
}

/// The same tower with an arm at its top is bolted to something: nobody lowers its center of mass.
TEST(Advice, WhatIsBoltedIsNotTopHeavy) {
  Scene scene = hand::scene();
  hand::add_body(scene, hand::box_mass(10, {0.2, 0.2, 2}), {0, 0, 1});
  hand::add_shape(scene, 0, mesh::Box{{0.2, 0.2, 2}});
  EXPECT_EQ(of_kind(causes_of(scene), FactKind::kCauseTopHeavy).size(), 1U);
  hand::add_body(scene, hand::ball_mass(1, 0.05), {0, 0, 2.2});
  hand::add_shape(scene, 1, mesh::Sphere{0.05});
  hand::add_joint(scene, model::JointType::kRevolute, 0, 1, {0, 0, 2}, {{0, 1, 0}});
  scene.joints.back().axes[0].lower = -1;
  scene.joints.back().axes[0].upper = 1;
  EXPECT_TRUE(of_kind(causes_of(scene), FactKind::kCauseTopHeavy).empty());
}

/// A tower without its foot's mesh may stand well: that it lacks it is all that is said.
TEST(Advice, MissingMeshesComeBeforeAllElse) {
  Scene scene = tutorial_robot();
  for (SceneShape& shape : scene.shapes) shape.link = 0;
  scene.links[0].model = 0;
  scene.models[0].missing_shapes = 2;
  scene.bodies[0].mass.com.z = 10;
  const Facts causes = causes_of(scene);
  const std::vector<Fact> missing = of_kind(causes, FactKind::kCauseMeshMissing);
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing[0].value, 2);
  EXPECT_EQ(missing[0].limit, 6);
  EXPECT_TRUE(of_kind(causes, FactKind::kCauseTopHeavy).empty());
  const Facts told = explain({.kind = FactKind::kTips}, causes);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].kind, FactKind::kCauseMeshMissing);
}

TEST(Advice, AStartOutsideLimitsAndAnEffortThatDoesNotCarry) {
  Scene scene = tutorial_robot();
  SceneBody arm;
  arm.name = "my_robot::arm";
  arm.X_WB.translation = {0.5, 0, 0.2};
  arm.mass = {2, {}, {0.1, 0, 0, 0.1, 0, 0.1}};
  scene.bodies.push_back(arm);
  scene.joints.push_back(hand::hinge("my_robot::shoulder", 0, 3, {0, 0, 0.2}, {0, 1, 0}));
  scene.joints[2].axes[0].lower = 0.3;
  scene.joints[2].axes[0].upper = 1;
  scene.joints[2].axes[0].effort = 5;
  const Facts causes = causes_of(scene);
  const std::vector<Fact> outside = of_kind(causes, FactKind::kCauseStartOutsideLimits);
  ASSERT_EQ(outside.size(), 1U);
  EXPECT_NEAR(outside[0].value, 0.3, 1e-12);
  scene.joints[2].axes[0].start = 0.5;
  EXPECT_TRUE(of_kind(causes_of(scene), FactKind::kCauseStartOutsideLimits).empty());
  const std::vector<Fact> weak = of_kind(causes, FactKind::kCauseEffort);
  ASSERT_EQ(weak.size(), 1U);
  EXPECT_NEAR(weak[0].value, 2 * 9.8 * 0.5, 1e-9);
  EXPECT_EQ(weak[0].limit, 5);
  EXPECT_FALSE(weak[0].slides);
  // It moves what it cannot hold, whatever is wrong besides.
  Facts with_inertia(3, {.kind = FactKind::kCauseInertia});
  with_inertia.push_back(weak[0]);
  for (const FactKind shown : {FactKind::kRestless, FactKind::kNeverSettles}) {
    EXPECT_EQ(explain({.kind = shown}, with_inertia).front().kind, FactKind::kCauseEffort);
  }
  scene.joints[2].type = model::JointType::kPrismatic;
  scene.joints[2].axes[0].direction_W = {0, 0, 1};
  const std::vector<Fact> sliding = of_kind(causes_of(scene), FactKind::kCauseEffort);
  ASSERT_EQ(sliding.size(), 1U);
  EXPECT_NEAR(sliding[0].value, 2 * 9.8, 1e-9);
  EXPECT_TRUE(sliding[0].slides);
}

TEST(Advice, AtMostThreeAreNamedAndTheLikeliestFirst) {
  Facts causes(5, {.kind = FactKind::kCauseInertia});
  causes.push_back({.kind = FactKind::kCauseCasterFriction});
  const Facts behind = explain({.kind = FactKind::kTurnOff}, causes);
  ASSERT_EQ(behind.size(), 3U);
  EXPECT_EQ(behind[0].kind, FactKind::kCauseCasterFriction);
  EXPECT_TRUE(explain({.kind = FactKind::kSpawnedAbove}, causes).empty());
}

}  // namespace
}  // namespace rigor
