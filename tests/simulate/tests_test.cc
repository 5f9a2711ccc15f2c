// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/test/tests.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <rigor/simulate/footprint.h>
#include <rigor/simulate/joint_load.h>
#include <rigor/simulate/scene/joint_cycles.h>
#include <rigor/simulate/test/parts.h>

#include "simulate/hand_robot.h"

namespace rigor {
namespace {

using namespace simulate;
using hand::hinge;
using hand::shape_of;
using hand::tutorial_robot;

Scenario made_test(std::string_view name, const Scene& scene) {
  const MadeTest made = make_test(name, scene, find_wheels(scene, {}));
  EXPECT_TRUE(made.scenario) << made.why_not;
  return made.scenario ? *made.scenario : Scenario{};
}

/// A crate on the ground that carries a joint: a pole of 1 kg, 0.4 m from the hinge at x = 0, z = 0.5.
Scene crate_with_pole() {
  Scene scene;
  scene.size = 1;
  scene.models.push_back({.name = "crate", .base = 0});
  SceneBody crate;
  crate.name = "crate::crate";
  crate.X_WB.translation = {0, 0, 0.25};
  crate.mass = {100, {}, {4, 0, 0, 4, 0, 4}};
  SceneBody pole;
  pole.name = "crate::pole";
  pole.X_WB.translation = {0.4, 0, 0.5};
  pole.mass = {1, {}, {0.02, 0, 0, 0.02, 0, 0.02}};
  scene.bodies = {crate, pole};
  scene.shapes = {shape_of(0, mesh::Box{{0.5, 0.5, 0.5}}), shape_of(1, mesh::Sphere{0.05})};
  scene.joints.push_back(hinge("crate::pole_joint", 0, 1, {0, 0, 0.5}, {0, -1, 0}));
  scene.joints[0].axes[0].lower = -0.5;
  scene.joints[0].axes[0].upper = 1;
  return scene;
}

TEST(Tests, AllThatAreNamedAreMadeForAWheeledRobot) {
  const Scene scene = tutorial_robot();
  for (const std::string_view name : kTestNames) {
    if (name == "joint-sweep" || name == "hold") continue;
    const Scenario scenario = made_test(name, scene);
    EXPECT_EQ(scenario.name, name);
    EXPECT_FALSE(scenario.phases.empty());
    for (const Phase& phase : scenario.phases) {
      EXPECT_LT(phase.begin, phase.end) << name;
      EXPECT_LE(phase.end, scenario.duration) << name;
    }
    for (const Command& command : scenario.commands) EXPECT_LE(command.end, scenario.duration);
  }
  EXPECT_EQ(make_test("joint-sweep", scene, find_wheels(scene, {})).scenario, std::nullopt)
      << "its wheels are no joints to sweep";
  EXPECT_FALSE(make_test("dance", scene, {}).why_not.empty());
}

TEST(Tests, DriveRampsForASecondAndThenKeepsItsSpeed) {
  const Scene scene = tutorial_robot();
  const Scenario drive = made_test("drive", scene);
  EXPECT_DOUBLE_EQ(drive.duration, 5);
  ASSERT_EQ(drive.commands.size(), 2U);
  // 0.3 √(2 · 9.8 m/s² · size), at a radius of 0.1 m.
  const double speed = 0.3 * std::sqrt(2 * 9.8 * scene.size);
  for (const Command& command : drive.commands) {
    EXPECT_NEAR(command.value, speed / 0.1, 1e-9);
    EXPECT_EQ(command.begin, 1);
    EXPECT_EQ(command.end, 5);
    EXPECT_EQ(command.ramp, 1);
    EXPECT_EQ(command.kind, CommandKind::kVelocity);
  }
}

TEST(Tests, DriveKeepsTheWheelsVelocityLimit) {
  Scene scene = tutorial_robot();
  scene.joints[1].axes[0].velocity = 2;
  for (const Command& command : made_test("drive", scene).commands) {
    EXPECT_NEAR(command.value, 2, 1e-12);
  }
}

TEST(Tests, DriveTellsAReversedWheelThePositiveVelocityToo) {
  Scene scene = tutorial_robot();
  scene.joints[1].axes[0].direction_W = {0, -1, 0};
  for (const Command& command : made_test("drive", scene).commands) EXPECT_GT(command.value, 0);
  // But `brake` and `turn` are about something else.
  double sum = 0;
  for (const Command& command : made_test("brake", scene).commands) sum += command.value;
  EXPECT_NEAR(sum, 0, 1e-12);
}

TEST(Tests, TurnHasAnArcAndASpin) {
  const Scenario turn = made_test("turn", tutorial_robot());
  double arc_left = 0;
  double arc_right = 0;
  double spin = 0;
  const auto begin_of = [&](std::string_view name) {
    return std::find_if(turn.phases.begin(), turn.phases.end(),
                        [&](const Phase& phase) { return phase.name == name; })
        ->begin;
  };
  for (const Command& command : turn.commands) {
    if (command.begin == begin_of("arc"))
      (command.joint == 0 ? arc_left : arc_right) = command.value;
    if (command.begin == begin_of("spin")) spin += command.value;
  }
  EXPECT_NEAR(arc_right, 2 * arc_left, 1e-12);
  EXPECT_GT(arc_left, 0);
  EXPECT_NEAR(spin, 0, 1e-12);
}

TEST(Tests, ATricycleDoesNotTurnByItsSidesSpeeds) {
  Scene scene = tutorial_robot();
  SceneBody fork;
  fork.X_WB.translation = {-0.15, 0, 0.1};
  scene.bodies.push_back(fork);
  scene.shapes[1].body = 3;
  scene.shapes[1].X_BS = {{0, 0, -0.05}, {}};
  scene.joints.push_back(hinge("fork", 0, 3, {-0.15, 0, 0.1}, {0, 0, 1}));
  scene.joints.back().axes[0].lower = -1;
  scene.joints.back().axes[0].upper = 1;
  EXPECT_FALSE(make_test("turn", scene, find_wheels(scene, {})).scenario);
  // In `drive` the fork is held straight.
  const Scenario drive = made_test("drive", scene);
  const auto& commands = drive.commands;
  EXPECT_TRUE(std::any_of(commands.begin(), commands.end(), [](const Command& command) {
    return command.joint == 2 && command.kind == CommandKind::kVelocity && command.value == 0;
  }));
}

/// A wheel on one side alone steers nothing. The other has limits, as no wheel has, which is said.
TEST(Tests, OfWheelsOnOneSideTheReasonIsTold) {
  Scene scene = tutorial_robot();
  scene.joints[1].name = "right_joint";
  scene.joints[1].axes[0].lower = -1;
  scene.joints[1].axes[0].upper = 1;
  for (const char* test : {"turn", "drive", "brake"}) {
    const MadeTest limited = make_test(test, scene, find_wheels(scene, {}));
    EXPECT_FALSE(limited.scenario) << test;
    EXPECT_NE(limited.why_not.find("on one side"), std::string::npos) << limited.why_not;
    EXPECT_NE(limited.why_not.find("joint 'right_joint' has limits"), std::string::npos)
        << limited.why_not;
  }
}

TEST(Tests, PushHasAFifthOfTheMomentumOfAFallAtTheCenterOfMass) {
  const Scene scene = tutorial_robot();
  const Scenario push = made_test("push", scene);
  ASSERT_EQ(push.pushes.size(), 1U);
  EXPECT_NEAR(length(push.pushes[0].impulse_W), 0.2 * 6 * std::sqrt(2 * 9.8 * scene.size), 1e-9);
  EXPECT_NEAR(push.pushes[0].impulse_W.x, 0, 1e-12) << "sideways: forward it would roll";
  // 1 kg of wheels at x = 0.1 and 5 kg of chassis at 0, all at z = 0.1, as the chassis' frame is.
  EXPECT_NEAR(push.pushes[0].p_BP.x, 0.1 / 6, 1e-12);
  EXPECT_NEAR(push.pushes[0].p_BP.z, 0, 1e-12);
}

TEST(Tests, TheTableTiltsTowardsTheWeakestSide) {
  Scene scene;
  scene.models.push_back({.name = "box", .base = 0});
  SceneBody body;
  body.X_WB.translation = {0, 0, 0.5};
  body.mass = {1, {0.05, 0, 0}, {1, 0, 0, 1, 0, 1}};
  scene.bodies = {body};
  scene.shapes = {shape_of(0, mesh::Box{{0.4, 0.8, 1}})};
  const Scenario table = made_test("tilt-table", scene);
  ASSERT_EQ(table.tilts.size(), 1U);
  // The edge at x = 0.2 is 0.15 from the center of mass, which is 0.5 above it. About -y, gravity turns
  // towards +x.
  EXPECT_NEAR(table.tilts[0].axis.y, -1, 1e-12);
  EXPECT_NEAR(table.tilts[0].angle, std::atan2(0.15, 0.5) + 0.1745, 1e-9);
}

TEST(Tests, ASweepGoesToBothLimitsAndBack) {
  const Scene scene = crate_with_pole();
  const Scenario sweep = made_test("joint-sweep", scene);
  std::vector<double> targets;
  for (const Command& command : sweep.commands) {
    if (command.kind == CommandKind::kPosition) targets.push_back(command.value);
  }
  EXPECT_EQ(targets, (std::vector<double>{-0.5, 1, 0}));
  EXPECT_EQ(sweep.phases.back().name, "sweep crate::pole_joint");
}

TEST(Tests, ASweepTakesAQuarterOfTheVelocityLimit) {
  Scene scene = crate_with_pole();
  scene.joints[0].axes[0].velocity = 4;
  double fastest = 0;
  for (const Command& command : made_test("joint-sweep", scene).commands) {
    if (command.kind == CommandKind::kVelocity)
      fastest = std::max(fastest, std::abs(command.value));
  }
  EXPECT_NEAR(fastest, 1, 1e-12);
}

TEST(Tests, ASweepsVelocitiesLeadToItsTargets) {
  const Scene scene = crate_with_pole();
  double at = 0;
  for (const Command& command : made_test("joint-sweep", scene).commands) {
    if (command.begin == 0) continue;  // stands still before
    if (command.kind == CommandKind::kPosition) {
      EXPECT_NEAR(at, command.value, 1e-9);
      continue;
    }
    // What the rise from rest lacks of the full speed, the fall to rest afterwards has.
    at += command.value * (command.end - command.begin);
  }
}

TEST(Tests, HoldHasGainsThatTheLoadHardlyBends) {
  const Scene scene = crate_with_pole();
  const Scenario hold = made_test("hold", scene);
  ASSERT_EQ(hold.commands.size(), 1U);
  ASSERT_TRUE(hold.commands[0].gains);
  const double load = 1 * 9.8 * 0.4;
  EXPECT_NEAR(JointLoads(scene).weight(scene.joints[0]), load, 1e-12);
  EXPECT_NEAR(JointLoads(scene).inertia(scene.joints[0]), 0.02 + 0.16, 1e-12);
  // The crate's own, about the hinge's line 0.25 m above its middle: 4 + 100 · 0.0625.
  EXPECT_NEAR(effective_inertia(scene, scene.joints[0]), 1 / (1 / 0.18 + 1 / 10.25), 1e-12);
  EXPECT_LE(load / hold.commands[0].gains->p, 0.005 + 1e-12);
  EXPECT_EQ(hold.commands[0].control, Control::kImplicit);
}

/// The stiffest spring that asks for all of the effort at 5 mrad.
TEST(Tests, HoldHasGainsThatTheEffortCanCarry) {
  Scene scene = crate_with_pole();
  scene.joints[0].axes[0].effort = 0.1;
  const Scenario hold = made_test("hold", scene);
  EXPECT_NEAR(hold.commands[0].gains->p, 0.1 / 0.005, 1e-9);
}

/// A table of 10 kg on a hinged leg of no weight, its foot 0.3 m beside the hinge, and on a fixed foot: each bears
/// half of it.
TEST(Tests, ALegBearsWhatStandsOnIt) {
  Scene scene;
  scene.size = 1;
  scene.models.push_back({.name = "table", .base = 0});
  SceneBody table;
  table.name = "table::top";
  table.X_WB.translation = {0, 0, 0.5};
  table.mass = {10, {}, {1, 0, 0, 1, 0, 1}};
  SceneBody leg;
  leg.name = "table::leg";
  leg.X_WB.translation = {0.3, 0, 0.05};
  leg.mass = {1e-9, {}, {1e-12, 0, 0, 1e-12, 0, 1e-12}};
  scene.bodies = {table, leg};
  scene.shapes = {shape_of(0, mesh::Sphere{0.05}, {{-0.3, 0, -0.45}, {}}),
                  shape_of(1, mesh::Sphere{0.05})};
  scene.joints.push_back(hinge("table::knee", 0, 1, {0, 0, 0.5}, {0, 1, 0}));
  EXPECT_NEAR(JointLoads(scene).standing(scene.joints[0]), 0.3 * 10 * 9.8 / 2, 1e-6);
  EXPECT_NEAR(JointLoads(scene).weight(scene.joints[0]), 0, 1e-6);
}

/// A body on two joints hangs on what bears them once, and a ring of joints has an end.
TEST(Tests, WhatHangsOnTwoJointsCountsOnce) {
  Scene scene = crate_with_pole();
  for (int i = 0; i < 2; ++i) {
    scene.bodies.push_back(scene.bodies[1]);
    scene.joints.push_back(hinge("crate::link", 1, 2, {0.4, 0, 0.5}, {0, -1, 0}));
  }
  scene.joints.push_back(hinge("crate::ring", 2, 1, {0.4, 0, 0.5}, {0, -1, 0}));
  EXPECT_EQ(CarriedBodies(scene).by(0), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(CarriedBodies(scene).by(3), std::vector<std::uint32_t>{3});
  EXPECT_NEAR(JointLoads(scene).weight(scene.joints[0]), 2 * 9.8 * 0.4, 1e-12);
  EXPECT_NEAR(JointLoads(scene).inertia(scene.joints[0]), 2 * (0.02 + 0.16), 1e-12);
}

TEST(Tests, BrakesHoldWhatIsNoWheelNoSpringAndNoFollower) {
  Scene scene = crate_with_pole();
  EXPECT_EQ(made_test("settle", scene).commands.size(), 1U);
  scene.joints[0].axes[0].spring_stiffness = 10;
  EXPECT_EQ(made_test("settle", scene).commands.size(), 0U);
  EXPECT_EQ(made_test("settle", scene).duration, 5) << "springs take longer";
  scene.joints[0].axes[0].spring_stiffness = 0;
  scene.joints[0].mimics.emplace_back();
  EXPECT_EQ(made_test("settle", scene).commands.size(), 0U);
  EXPECT_EQ(made_test("settle", tutorial_robot()).commands.size(), 0U);
}

/// 1 kg at 0.4 m, 0.18 kg·m² about the hinge, which starts level at 4 rad/s².
TEST(Tests, ASweepTakesTheWeightAndWhatStartsAndStopsIt) {
  Scene scene = crate_with_pole();
  SceneJoint& joint = scene.joints[0];
  const double weight = 1 * 9.8 * 0.4;
  EXPECT_NEAR(JointLoads(scene).sweep_effort(joint, {-0.5, 1, 1, 0}), weight, 1e-12);
  EXPECT_NEAR(JointLoads(scene).sweep_effort(joint, {-0.5, 1, 1, 4}), weight + 0.18 * 4, 1e-12);
  // Of a way that is above the level: where it is lowest.
  joint.axes[0].start = 0.5;
  EXPECT_NEAR(JointLoads(scene).sweep_effort(joint, {1, 1.2, 1, 0}), weight, 1e-12)
      << "it begins level";
  scene.bodies[1].X_WB.translation = {0, 0, 0.9};  // now it begins upright
  EXPECT_NEAR(JointLoads(scene).sweep_effort(joint, {0.5, 0.7, 1, 0}), weight * std::sin(0.2),
              1e-12);
  joint.axes[0].friction = 2;
  joint.axes[0].damping = 3;
  EXPECT_NEAR(JointLoads(scene).sweep_effort(joint, {-2, 2, 0.5, 0}), weight + 2 + 1.5, 1e-12);
  joint = {};
  joint.type = model::JointType::kPrismatic;
  joint.parent = 0;
  joint.child = 1;
  joint.axes.push_back({.direction_W = {0, 0.6, 0.8}});
  EXPECT_NEAR(JointLoads(scene).sweep_effort(joint, {-1, 1, 1, 0.5}), 0.8 * 9.8 + 0.5, 1e-12);
}

/// Limits of two turns, as arms have them, make no wheel of what lies on the ground; nor does a box.
TEST(Tests, AnArmThatTouchesTheGroundIsNoCaster) {
  Scene scene = crate_with_pole();
  SceneAxis& axis = scene.joints[0].axes[0];
  scene.shapes[1].X_BS.translation = {0, 0, -0.45};  // the pole's ball is on the ground
  axis.lower = -2 * 3.14159265359;
  axis.upper = 2 * 3.14159265359;
  EXPECT_EQ(made_test("settle", scene).commands.size(), 1U);
  EXPECT_EQ(made_test("hold", scene).commands.size(), 1U);
  EXPECT_EQ(made_test("joint-sweep", scene).phases.back().name, "sweep crate::pole_joint");
  axis.lower = -kInfinity;
  axis.upper = kInfinity;
  EXPECT_EQ(made_test("settle", scene).commands.size(), 1U) << "it is not round about the hinge";
}

TEST(Tests, WheelsForksAndWhatCarriesAWheelRoll) {
  Scene scene = crate_with_pole();
  SceneJoint& joint = scene.joints[0];
  joint.axes[0].lower = -kInfinity;
  joint.axes[0].upper = kInfinity;
  scene.shapes[1] = shape_of(1, mesh::Sphere{0.1});
  scene.bodies[1].X_WB.translation = joint.anchor_W = {0.4, 0, 0.1};
  EXPECT_TRUE(rolling_joints(scene)[0]);
  joint.axes[0].direction_W = {0, 0, 1};
  joint.anchor_W = {0.3, 0, 0.1};
  EXPECT_TRUE(rolling_joints(scene)[0]) << "a fork with its wheel";
  // The fork without a shape, and a wheel that turns in it.
  scene.bodies.push_back(scene.bodies[1]);
  scene.shapes[1].body = 2;
  scene.joints.push_back(hinge("crate::wheel", 1, 2, {0.4, 0, 0.1}, {0, 1, 0}));
  EXPECT_TRUE(rolling_joints(scene)[0]);
  EXPECT_TRUE(rolling_joints(scene)[1]);
  scene.joints[0].axes[0].lower = -1;
  scene.joints[0].axes[0].upper = 1;
  EXPECT_FALSE(rolling_joints(scene)[0]) << "it is steered";
  EXPECT_TRUE(rolling_joints(scene)[1]);
}

TEST(Tests, JointsWithoutAnEffortAreNeitherHeldNorSwept) {
  Scene scene = crate_with_pole();
  scene.joints[0].axes[0].effort = 0;
  const std::string why = "no motor can move a joint: their effort limits are 0";
  for (const char* test : {"hold", "joint-sweep"}) {
    EXPECT_EQ(make_test(test, scene, {}).why_not, why);
  }
  SceneBody arm = scene.bodies[1];
  scene.bodies.push_back(arm);
  scene.joints.push_back(hinge("crate::arm_joint", 1, 2, {0.4, 0, 0.5}, {0, -1, 0}));
  const MadeTest hold = make_test("hold", scene, {});
  ASSERT_EQ(hold.scenario->commands.size(), 1U);
  EXPECT_EQ(hold.scenario->commands[0].joint, 1U);
  EXPECT_EQ(hold.note, "joints whose effort limit is 0 move freely");
}

TEST(Tests, JointsAreHeldAndSweptFromWhereTheyStart) {
  Scene scene = crate_with_pole();
  scene.joints[0].axes[0].start = 0.4;
  EXPECT_EQ(made_test("hold", scene).commands.at(0).value, 0.4);
  const Scenario sweep = made_test("joint-sweep", scene);
  double last = 0;
  for (const Command& command : sweep.commands) {
    if (command.kind == CommandKind::kPosition) last = command.value;
  }
  EXPECT_EQ(last, 0.4);
}

/// Two levers on a plate and a bar between them: a loop of four hinges.
Scene four_bar() {
  Scene scene;
  scene.size = 0.6;
  scene.models.push_back({.name = "bar", .base = 0});
  for (const Vector3& p : {Vector3{0, 0, 0.05}, Vector3{-0.2, 0, 0.3}, Vector3{0.2, 0, 0.3},
                           Vector3{0, 0, 0.45}, Vector3{0.5, 0, 0.3}}) {
    SceneBody body;
    body.name = "bar::" + std::to_string(scene.bodies.size());
    body.X_WB.translation = p;
    body.mass = {0.2, {}, {0.002, 0, 0, 0.002, 0, 0.002}};
    scene.bodies.push_back(body);
  }
  scene.bodies[0].mass = {5, {}, {0.1, 0, 0, 0.1, 0, 0.1}};
  scene.joints = {hinge("bar::crank", 0, 1, {-0.2, 0, 0.15}, {0, 1, 0}),
                  hinge("bar::rocker", 0, 2, {0.2, 0, 0.15}, {0, 1, 0}),
                  hinge("bar::near", 1, 3, {-0.2, 0, 0.45}, {0, 1, 0}),
                  hinge("bar::far", 2, 3, {0.2, 0, 0.45}, {0, 1, 0}),
                  hinge("bar::other", 0, 4, {0.5, 0, 0.15}, {0, 1, 0})};
  for (SceneJoint& joint : scene.joints) {
    joint.axes[0].lower = -0.4;
    joint.axes[0].upper = 0.4;
  }
  return scene;
}

TEST(Tests, JointsOfALoopAreFound) {
  const std::vector<std::uint32_t> cycles = joint_cycles(four_bar());
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_NE(cycles[j], kWorld);
    EXPECT_EQ(cycles[j], cycles[0]);
  }
  EXPECT_EQ(cycles[4], kWorld);
  Scene open = four_bar();
  open.joints.pop_back();
  open.joints.pop_back();
  EXPECT_EQ(joint_cycles(open), std::vector<std::uint32_t>(3, kWorld));
  // Two hinges on the world hold what is between them.
  open.joints.push_back(hinge("bar::wall", 3, kWorld, {}, {0, 1, 0}));
  open.joints.push_back(hinge("bar::floor", kWorld, 0, {}, {0, 1, 0}));
  EXPECT_EQ(joint_cycles(open), (std::vector<std::uint32_t>{0, kWorld, 0, 0, 0}));
}

/// A lever does not move while the others of its loop are held.
TEST(Tests, ASweepLetsTheOtherJointsOfALoopGo) {
  const Scene scene = four_bar();
  const Scenario sweep = made_test("joint-sweep", scene);
  ASSERT_EQ(sweep.phases.size(), 6U);  // it settles, and one for each joint
  for (std::size_t j = 0; j < 5; ++j) {
    const Phase& phase = sweep.phases[1 + j];
    for (const Command& command : sweep.commands) {
      const bool meets = command.begin < phase.end - 1e-9 && command.end > phase.begin + 1e-9;
      const bool same_loop = j < 4 && command.joint < 4 && command.joint != j;
      EXPECT_FALSE(same_loop && meets) << command.joint << " in " << phase.name;
    }
    const auto stands_in = [&](std::uint32_t joint) {
      return std::any_of(sweep.commands.begin(), sweep.commands.end(), [&](const Command& command) {
        return command.joint == joint && command.begin <= phase.begin && command.end >= phase.end;
      });
    };
    EXPECT_TRUE(j == 4 || stands_in(4)) << "what is in no loop stands";
  }
}

/// 200 kg and 87 N: 0.435 m/s² and no more. With half of that it starts and stops.
TEST(Tests, ASweepStartsWithinTheEffortOfTheJoint) {
  Scene scene;
  scene.size = 1;
  scene.models.push_back({.name = "slide", .base = kWorld});
  SceneBody cart;
  cart.name = "slide::cart";
  cart.mass = {200, {}, {4, 0, 0, 4, 0, 6}};
  scene.bodies = {cart};
  scene.joints = {hinge("slide::x", kWorld, 0, {}, {1, 0, 0})};
  scene.joints[0].type = model::JointType::kPrismatic;
  scene.joints[0].axes[0].lower = -5;
  scene.joints[0].axes[0].upper = 5;
  scene.joints[0].axes[0].effort = 87;
  scene.joints[0].axes[0].velocity = 2.175;
  const Scenario sweep = made_test("joint-sweep", scene);
  double way = 0;
  for (const Command& command : sweep.commands) {
    if (command.kind != CommandKind::kVelocity || command.value == 0) continue;
    EXPECT_LE(200 * std::abs(command.value) / command.ramp, 87 * 0.5 * 1.001);
    way += command.value * (command.end - command.begin);
  }
  EXPECT_NEAR(way, 0, 1e-9);  // there and back
}

/// A push leans a ball as far as it rolls.
TEST(Tests, WhatIsRoundIsNotTippedOver) {
  Scene scene;
  scene.models.push_back({.name = "round", .base = 0});
  SceneBody body;
  body.name = "round::body";
  body.X_WB.translation = {0, 0, 0.1};
  body.mass = {1, {}, {0.004, 0, 0, 0.004, 0, 0.004}};
  scene.bodies = {body};
  const Quaternion on_its_side = model::from_rpy(1.5707963, 0, 0);
  for (const SceneShapeKind& kind :
       {SceneShapeKind{mesh::Sphere{0.1}}, SceneShapeKind{mesh::Cylinder{0.1, 1}}}) {
    scene.shapes = {shape_of(0, kind, {{}, on_its_side})};
    for (const char* test : {"push", "tilt-table"}) {
      EXPECT_EQ(make_test(test, scene, {}).why_not, "it is round and rolls") << test;
    }
  }
  scene.shapes[0].X_BS.rotation = {};
  EXPECT_TRUE(make_test("push", scene, {}).scenario);
}

}  // namespace
}  // namespace rigor
