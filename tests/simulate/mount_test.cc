// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/mount.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include <rigor/simulate/metric/metric.h>
#include <rigor/simulate/plan.h>
#include <rigor/simulate/run.h>
#include <rigor/simulate/stage.h>
#include <rigor/simulate/test/tests.h>

#include "simulate/hand_robot.h"
#include "simulate/hand_scene.h"

namespace rigor {
namespace {

using namespace simulate;

/// A foot of 1 kg, 0.2 m wide, and two poles of 5 kg that reach 0.6 m out of it, along x and along `second`.
Scene lamp(const Vector3& second) {
  Scene scene = hand::scene();
  scene.size = 1.2;
  hand::add_body(scene, hand::box_mass(1, {0.2, 0.2, 0.2}), {0, 0, 0.1});
  hand::add_body(scene, hand::ball_mass(5, 0.05), {0.6, 0, 0.3});
  hand::add_body(scene, hand::ball_mass(5, 0.05), 0.6 * second + Vector3{0, 0, 0.3});
  hand::add_shape(scene, 0, mesh::Box{{0.2, 0.2, 0.2}});
  for (std::uint32_t pole = 1; pole <= 2; ++pole) {
    hand::add_shape(scene, pole, mesh::Sphere{0.05});
    hand::add_joint(scene, model::JointType::kRevolute, 0, pole, {0, 0, 0.3}, {{0, 0, 1}});
    scene.joints.back().axes[0].lower = -1;
    scene.joints.back().axes[0].upper = 1;
  }
  return scene;
}

const Vector3 kSameSide{0.8, 0.6, 0};
const Vector3 kOtherSide{-1, 0, 0};

TEST(Mount, WhatCannotStandHangsAndWhatStandsIsFree) {
  const DriveTrain none;
  for (const char* test : {"settle", "hold"}) {
    EXPECT_EQ(choose_mount(test, lamp(kSameSide), none).base, Base::kHang) << test;
    EXPECT_EQ(choose_mount(test, lamp(kOtherSide), none).base, Base::kFree) << test;
  }
  // A sweep moves the center of mass about.
  EXPECT_EQ(choose_mount("joint-sweep", lamp(kOtherSide), none).base, Base::kHang);
}

/// A plate 8 mm above the ground keeps nothing up until it has rocked onto it.
TEST(Mount, ARigidBaseStandsOnWhatTouchesTheGround) {
  Scene rocking = lamp(kSameSide);
  hand::add_shape(rocking, 0, mesh::Box{{1.6, 1.6, 0.01}}, {{0, 0, -0.087}, {}});
  EXPECT_EQ(choose_mount("settle", rocking, {}).base, Base::kHang);
  rocking.shapes.back().X_BS.translation.z = -0.095;
  EXPECT_EQ(choose_mount("settle", rocking, {}).base, Base::kFree);
}

TEST(Mount, WheelsWorldsAndWhatNoJointMovesStandByThemselves) {
  const Scene robot = hand::tutorial_robot();
  EXPECT_EQ(choose_mount("joint-sweep", robot, find_wheels(robot, {})).base, Base::kFree);
  Scene world = lamp(kSameSide);
  world.alone = false;
  EXPECT_EQ(choose_mount("settle", world, {}).base, Base::kFree);
  Scene object = lamp(kSameSide);
  for (SceneJoint& joint : object.joints) joint.type = model::JointType::kBall;
  EXPECT_EQ(choose_mount("settle", object, {}).base, Base::kFree);
  Scene bolted = mounted(lamp(kSameSide), Base::kFixed);
  EXPECT_EQ(choose_mount("settle", bolted, {}).base, Base::kFree);
  // Swept from limit to limit it reaches below what it is bolted to.
  EXPECT_EQ(choose_mount("joint-sweep", bolted, {}).base, Base::kHang);
  // Over the edge of the table that it is bolted to.
  bolted.bodies[1].X_WB.translation.z = -0.1;
  EXPECT_EQ(choose_mount("settle", bolted, {}).base, Base::kHang);
}

TEST(Mount, AnArmIsToBeBoltedAndALegIsNot) {
  EXPECT_TRUE(is_to_be_bolted(lamp(kOtherSide), 0, {}));  // its base alone touches the ground
  Scene legged = lamp(kOtherSide);
  for (const std::uint32_t pole : {1U, 2U}) legged.bodies[pole].X_WB.translation.z = 0.05;
  EXPECT_FALSE(is_to_be_bolted(legged, 0, {}));
  const Scene robot = hand::tutorial_robot();
  EXPECT_FALSE(is_to_be_bolted(robot, 0, find_wheels(robot, {})));
}

/// 0.6 m aside 5 kg tip the foot within a second; held, it does not move, and the poles are held by their motors.
TEST(Mount, AHeldBaseStaysWhereItIs) {
  const Scene scene = lamp(kSameSide);
  Scenario settle = *make_test("settle", scene, {}).scenario;
  const auto fallen = [&](Base base) {
    settle.base = base;
    const Record record = run(stage(scene, settle), settle, scene.solver);
    return length(record.final.bodies[0].p_WBcm - Vector3{0, 0, 0.1});
  };
  EXPECT_GT(fallen(Base::kFree), 0.05);
  EXPECT_LT(fallen(Base::kFixed), 1e-4);
  EXPECT_LT(fallen(Base::kHang), 1e-4);
}

/// A ball that no joint holds would fall by 4.9 m in a second.
TEST(Mount, WhatNoJointConnectsIsHeldToo) {
  Scene scene = lamp(kSameSide);
  hand::add_body(scene, hand::ball_mass(1, 0.05), {0, 0, 1});
  const Scene held = mounted(scene, Base::kHang);
  ASSERT_EQ(held.joints.size(), scene.joints.size() + 2);
  EXPECT_EQ(held.joints[2].child, 0U);
  EXPECT_EQ(held.joints[3].child, 3U);
  EXPECT_EQ(mounted(held, Base::kHang).joints.size(), held.joints.size());
}

TEST(Mount, APlanSaysWhichBasesItHolds) {
  const Scene scene = lamp(kSameSide);
  const Planned planned = scenarios_of({.tests = {"settle", "hold", "push"}}, scene, {});
  ASSERT_EQ(planned.scenarios.size(), 2U);
  EXPECT_EQ(planned.scenarios[0].base, Base::kHang);
  ASSERT_EQ(planned.notes.size(), 1U);
  EXPECT_EQ(planned.notes[0].substr(0, 14), "settle, hold: ");
  ASSERT_EQ(planned.left_out.size(), 1U);
  EXPECT_EQ(planned.left_out[0], "push: its center of mass is not above what it stands on");
  const Planned free =
      scenarios_of({.tests = {"settle", "push"}, .base = BaseOption::kFree}, scene, {});
  EXPECT_EQ(free.scenarios.size(), 2U);
  EXPECT_EQ(free.scenarios[0].base, Base::kFree);
  EXPECT_TRUE(free.notes.empty());
}

/// A lamp with one joint a pole tips over; an arm with some in a row is bolted down.
TEST(Mount, WhatTipsOverAndIsNoArmIsAFinding) {
  Scene scene = lamp(kSameSide);
  const auto found = [&](std::vector<std::string> tests) {
    const Planned planned = scenarios_of({.tests = std::move(tests)}, scene, {});
    return planned.facts.size() == 1 && planned.facts[0].kind == FactKind::kHeldUp &&
           !planned.facts[0].severe;
  };
  EXPECT_TRUE(found({"settle", "hold"}));
  EXPECT_TRUE(found({"push"}));  // which is left out
  EXPECT_FALSE(found({"joint-sweep"}));
  hand::add_body(scene, hand::ball_mass(1, 0.05), {0.6, 0, 0.4});
  hand::add_joint(scene, model::JointType::kRevolute, 2, 3, {0.6, 0, 0.3}, {{0, 1, 0}});
  EXPECT_FALSE(found({"settle", "hold"}));
  scene = lamp(kOtherSide);
  EXPECT_FALSE(found({"settle", "hold"}));  // it stands
}

double begin_of(const Scenario& sweep, const std::string& joint) {
  for (const Phase& phase : sweep.phases) {
    if (phase.name == "sweep " + joint) return phase.begin;
  }
  return -1;
}

/// On a base that is held two branches do not feel each other.
TEST(Mount, BranchesOfAHeldBaseAreSweptAtTheSameTime) {
  const Scene scene = lamp(kOtherSide);
  const Scenario held = *make_test("joint-sweep", mounted(scene, Base::kHang), {}).scenario;
  EXPECT_EQ(begin_of(held, "robot::joint0"), begin_of(held, "robot::joint1"));
  const Scenario free = *make_test("joint-sweep", scene, {}).scenario;
  EXPECT_LT(begin_of(free, "robot::joint0"), begin_of(free, "robot::joint1"));
  EXPECT_LT(held.duration, free.duration);
  // Links that may touch go one after the other, and so do those of one chain.
  Scene touching = mounted(scene, Base::kHang);
  touching.bodies[1].self_collide = true;
  const Scenario serial = *make_test("joint-sweep", touching, {}).scenario;
  EXPECT_EQ(serial.duration, free.duration);
  Scene chain = mounted(scene, Base::kHang);
  chain.joints[1].parent = 1;
  const Scenario one_by_one = *make_test("joint-sweep", chain, {}).scenario;
  EXPECT_EQ(one_by_one.duration, free.duration);
}

/// The metric of each joint is of its own sweep, though another is at the same time.
TEST(Mount, ASweepIsJudgedByItsOwnCommands) {
  Scene scene = mounted(lamp(kOtherSide), Base::kHang);
  scene.joints[1].axes[0].lower = -0.25;
  Scenario sweep = *make_test("joint-sweep", scene, {}).scenario;
  sweep.base = Base::kHang;
  const Record record = run(stage(scene, sweep), sweep, scene.solver);
  const std::vector<Metric> metrics = metrics_of(scene, sweep, record, {});
  const auto reach = std::find_if(metrics.begin(), metrics.end(),
                                  [](const Metric& metric) { return metric.id == "joint.reach"; });
  ASSERT_NE(reach, metrics.end());
  EXPECT_LT(reach->value, 0.01);
}

}  // namespace
}  // namespace rigor
