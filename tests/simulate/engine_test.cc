// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/ode/ode_engine.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rigor/mesh/convex/hull.h>

#include "simulate/engines.h"
#include "simulate/hand_scene.h"

namespace rigor {
namespace {

using hand::add_body;
using hand::add_ground;
using hand::add_joint;
using hand::add_shape;
using hand::Scene;
using hand::Vector3;
using model::JointType;
using simulate::Engine;
using simulate::Forces;
using simulate::kWorld;
using simulate::SolverSettings;

constexpr double kWeight = 9.8;  // N/kg
constexpr double kHalfTurn = 3.14159265358979323846;

class Engines : public test::Engines {
 protected:
  double upper_height(const Scene& scene) const;
};

INSTANTIATE_TEST_SUITE_P(Each, Engines,
                         testing::Values(simulate::EngineKind::kOde, simulate::EngineKind::kMujoco),
                         test::engine_name);

void step_engine(Engine& engine, int steps) {
  for (int i = 0; i < steps; ++i) engine.step(Forces::kAsked);
}

// A dumbbell whose middle lies off its frame's origin falls with its middle straight down.
TEST_P(Engines, StandsBodiesAtTheirCenterOfMass) {
  Scene scene = hand::scene();
  mass::MassProperties body = hand::box_mass(2, {0.1, 0.2, 0.3});
  body.com = {0.5, -0.2, 0.1};
  add_body(scene, body, {1, 2, 3}, model::from_rpy(0, 0, kHalfTurn / 2));
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  const Vector3 com = engine.state().bodies[0].p_WBcm;
  EXPECT_NEAR(com.x, 1.2, 1e-12);
  EXPECT_NEAR(com.y, 2.5, 1e-12);
  EXPECT_NEAR(com.z, 3.1, 1e-12);
  step_engine(engine, 500);
  EXPECT_NEAR(engine.state().bodies[0].p_WBcm.x, 1.2, 1e-12);
  EXPECT_NEAR(length(engine.state().bodies[0].w_WB), 0, 1e-12);
  const auto pose = pose_of(scene.bodies[0], engine.state().bodies[0]);
  EXPECT_NEAR(pose.translation.x, 1, 1e-12);
  EXPECT_NEAR(pose.translation.y, 2, 1e-12);
}

// A shape's offset is from its body's frame, not from the center of mass: this one rests on its ball.
TEST_P(Engines, HangsShapesOnTheFrame) {
  Scene scene = hand::scene();
  mass::MassProperties body = hand::ball_mass(1, 0.1);
  body.com = {0, 0, -0.05};
  add_body(scene, body, {0, 0, 1});
  add_shape(scene, 0, mesh::Sphere{0.2}, {{0, 0, 0.3}, {}});
  add_ground(scene);
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  step_engine(engine, 1500);
  const auto pose = pose_of(scene.bodies[0], engine.state().bodies[0]);
  EXPECT_NEAR(model::transform(pose, {0, 0, 0.3}).z, 0.2, 2e-3);
}

// An impulse pair about an axis turns a body by I⁻¹ L; all six entries, with both signs.
TEST_P(Engines, TakesTheTensorsEntriesAsTheyAreWritten) {
  const mass::Inertia I{.ixx = 2, .ixy = 0.3, .ixz = -0.4, .iyy = 3, .iyz = 0.5, .izz = 4};
  for (const Vector3& w : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
    Scene scene = hand::scene();
    scene.gravity = {};
    add_body(scene, {1, {}, I}, {});
    const auto engine_made = made_engine(scene, hand::stiff());
    Engine& engine = *engine_made;
    // The angular momentum that gives this turn: I w.
    const Vector3 L{I.ixx * w.x + I.ixy * w.y + I.ixz * w.z,
                    I.ixy * w.x + I.iyy * w.y + I.iyz * w.z,
                    I.ixz * w.x + I.iyz * w.y + I.izz * w.z};
    // Two opposite impulses across a lever of 1 m each way make L = r × J twice.
    const double scale = 1e-6;  // slow enough that the gyroscopic term is nothing
    const auto couple = [&](const Vector3& r, const Vector3& impulse) {
      engine.push(0, (scale / 2) * impulse, r);
      engine.push(0, (-scale / 2) * impulse, (-1.0) * r);
    };
    couple({0, 1, 0}, {0, 0, L.x});  // y × z = x
    couple({0, 0, 1}, {L.y, 0, 0});  // z × x = y
    couple({1, 0, 0}, {0, L.z, 0});  // x × y = z
    engine.step();
    const Vector3 got = (1 / scale) * engine.state().bodies[0].w_WB;
    EXPECT_NEAR(got.x, w.x, 1e-5);
    EXPECT_NEAR(got.y, w.y, 1e-5);
    EXPECT_NEAR(got.z, w.z, 1e-5);
  }
}

/// A body under a joint to a heavy one that floats still.
struct JointCase {
  JointType type;
  std::vector<Vector3> axes;
};

Scene joint_scene(const JointCase& made, bool to_world) {
  Scene scene = hand::scene();
  scene.gravity = {};
  const auto base = add_body(scene, hand::ball_mass(1e4, 1), {0.3, 0, 0});
  const auto arm = add_body(scene, hand::ball_mass(1, 0.3), {0, 0, 0});
  add_joint(scene, made.type, to_world ? kWorld : base, arm, {0, 0, 0}, made.axes);
  return scene;
}

// The child moves against the parent along the axis: its own rotation and place say which way.
TEST_P(Engines, MeasuresPositionsAsSdfDoes) {
  for (const bool to_world : {false, true}) {
    const Scene hinge = joint_scene({JointType::kRevolute, {{0, 0, 1}}}, to_world);
    const auto turning_made = made_engine(hinge, hand::stiff());
    Engine& turning = *turning_made;
    turning.set_effort(0, 0, 0.01);
    step_engine(turning, 500);
    const auto turned = turning.state().bodies[1];
    EXPECT_GT(turned.w_WB.z, 0);
    EXPECT_NEAR(turning.state().axes[0].velocity, turned.w_WB.z, 1e-4);
    EXPECT_NEAR(turning.state().axes[0].position, 2 * std::asin(turned.R_WB.z), 1e-4);
    // τ = I a: 0.01 N·m on 0.036 kg·m² for half a second.
    EXPECT_NEAR(turned.w_WB.z, 0.01 / 0.036 * 0.5, 1e-4);
    EXPECT_NEAR(turning.state().motor_work, 0.036 * turned.w_WB.z * turned.w_WB.z / 2, 1e-5);

    const Scene slider = joint_scene({JointType::kPrismatic, {{0, 0, 1}}}, to_world);
    const auto sliding_made = made_engine(slider, hand::stiff());
    Engine& sliding = *sliding_made;
    sliding.set_effort(0, 0, 2);
    step_engine(sliding, 500);
    EXPECT_NEAR(sliding.state().bodies[1].v_WBcm.z, 1, 1e-3);
    EXPECT_NEAR(sliding.state().axes[0].velocity, 1, 1e-3);
    EXPECT_NEAR(sliding.state().axes[0].position, sliding.state().bodies[1].p_WBcm.z, 1e-4);
  }
}

// R_PC = Rot(first, q1) Rot(second, q2): the first axis stays with the parent.
TEST_P(Engines, UniversalTurnsAboutTheParentsAxisFirst) {
  for (const JointType type : {JointType::kUniversal, JointType::kRevolute2}) {
    for (const bool to_world : {false, true}) {
      const Scene scene = joint_scene({type, {{0, 0, 1}, {0, 1, 0}}}, to_world);
      const auto engine_made = made_engine(scene, hand::stiff());
      Engine& engine = *engine_made;
      for (int i = 0; i < 500; ++i) {
        engine.set_motor(0, 0, 1.0, 100);
        engine.set_motor(0, 1, -0.6, 100);
        engine.step();
      }
      const double q1 = engine.state().axes[0].position;
      const double q2 = engine.state().axes[1].position;
      EXPECT_NEAR(q1, 0.5, 5e-3);
      EXPECT_NEAR(q2, -0.3, 5e-3);
      EXPECT_NEAR(engine.state().axes[0].velocity, 1, 1e-2);
      EXPECT_NEAR(engine.state().axes[1].velocity, -0.6, 1e-2);
      const auto expected =
          model::from_axis_angle({0, 0, 1}, q1) * model::from_axis_angle({0, 1, 0}, q2);
      const auto& R = engine.state().bodies[1].R_WB;
      EXPECT_NEAR(
          std::abs(R.w * expected.w + R.x * expected.x + R.y * expected.y + R.z * expected.z), 1,
          1e-5);
    }
  }
}

// Each axis of each kind of joint stops where it is told, on both sides.
TEST_P(Engines, StopsAtItsLimits) {
  const std::vector<JointCase> kinds{{JointType::kRevolute, {{0, 0, 1}}},
                                     {JointType::kPrismatic, {{0, 0, 1}}},
                                     {JointType::kScrew, {{0, 0, 1}}},
                                     {JointType::kUniversal, {{0, 0, 1}, {0, 1, 0}}}};
  for (const JointCase& kind : kinds) {
    for (std::uint32_t axis = 0; axis < kind.axes.size(); ++axis) {
      for (const double push : {-1.0, 1.0}) {
        Scene scene = joint_scene(kind, false);
        scene.joints[0].screw_pitch = 0.01;
        scene.joints[0].axes[axis].lower = -0.2;
        scene.joints[0].axes[axis].upper = 0.3;
        const auto engine_made = made_engine(scene, hand::stiff());
        Engine& engine = *engine_made;
        engine.set_effort(0, axis, push);
        step_engine(engine, 3000);
        EXPECT_NEAR(engine.state().axes[axis].position, push > 0 ? 0.3 : -0.2, 2e-3)
            << to_string(kind.type) << axis;
        // A motor presses against the stop and leaves it again.
        engine.set_motor(0, axis, push, 1000);
        step_engine(engine, 200);
        EXPECT_NEAR(engine.state().axes[axis].position, push > 0 ? 0.3 : -0.2, 2e-3);
        engine.set_motor(0, axis, -push, 1000);
        step_engine(engine, 100);
        EXPECT_NEAR(engine.state().axes[axis].position, (push > 0 ? 0.3 : -0.2) - 0.1 * push, 5e-3)
            << to_string(kind.type) << axis;
        EXPECT_NEAR(engine.state().axes[axis].velocity, -push, 1e-2);
      }
    }
  }
}

// Limits of more than half a turn, which ODE has not; and counting over full turns.
TEST_P(Engines, LimitsBeyondHalfATurnHold) {
  Scene scene = joint_scene({JointType::kRevolute, {{0, 0, 1}}}, true);
  scene.joints[0].axes[0].lower = -4.5;
  scene.joints[0].axes[0].upper = 9;
  for (const double speed : {-2.0, 2.0}) {
    const auto engine_made = made_engine(scene, hand::stiff());
    Engine& engine = *engine_made;
    engine.set_motor(0, 0, speed, 10);
    double farthest = 0;
    for (int i = 0; i < 6000; ++i) {
      engine.step();
      farthest = std::max(farthest, std::abs(engine.state().axes[0].position));
    }
    EXPECT_NEAR(engine.state().axes[0].position, speed > 0 ? 9 : -4.5, 5e-3);
    EXPECT_LT(farthest, (speed > 0 ? 9 : 4.5) + 5e-3);
  }
}

// A run may begin with joints that are not at zero: limits, springs and what follows count on from there.
TEST_P(Engines, CountsFromWhereAJointStarts) {
  const std::vector<JointCase> kinds{{JointType::kRevolute, {{0, 0, 1}}},
                                     {JointType::kPrismatic, {{0, 0, 1}}},
                                     {JointType::kScrew, {{0, 0, 1}}},
                                     {JointType::kUniversal, {{0, 0, 1}, {0, 1, 0}}}};
  for (const JointCase& kind : kinds) {
    for (const double push : {-1.0, 1.0}) {
      Scene scene = joint_scene(kind, false);
      scene.joints[0].screw_pitch = 0.01;
      scene.joints[0].axes[0].start = 0.5;
      scene.joints[0].axes[0].lower = 0.2;
      scene.joints[0].axes[0].upper = 0.6;
      const auto engine_made = made_engine(scene, hand::stiff());
      Engine& engine = *engine_made;
      EXPECT_NEAR(engine.state().axes[0].position, 0.5, 1e-12);
      engine.set_motor(0, 0, push, 1000);
      step_engine(engine, 50);
      EXPECT_NEAR(engine.state().axes[0].position, 0.5 + 0.05 * push, 5e-3);
      engine.set_effort(0, 0, push);
      step_engine(engine, 3000);
      const double end = push > 0 ? 0.6 : 0.2;
      EXPECT_NEAR(engine.state().axes[0].position, end, 2e-3) << to_string(kind.type);
      if (kind.type != JointType::kRevolute) continue;
      // It has turned by what is between, no more.
      EXPECT_NEAR(2 * std::asin(engine.state().bodies[1].R_WB.z), end - 0.5, 5e-3);
    }
  }
}

TEST_P(Engines, WhatStartsAtRestInASpringOrAMimicStays) {
  Scene scene = hand::scene();
  scene.gravity = {};
  const auto one = add_body(scene, hand::ball_mass(1, 0.3), {});
  const auto two = add_body(scene, hand::ball_mass(1, 0.3), {2, 0, 0});
  add_joint(scene, JointType::kRevolute, kWorld, one, {}, {{0, 0, 1}});
  add_joint(scene, JointType::kRevolute, kWorld, two, {2, 0, 0}, {{0, 0, 1}});
  scene.joints[0].axes[0].start = 0.5;
  scene.joints[0].axes[0].spring_reference = 0.5;
  scene.joints[0].axes[0].spring_stiffness = 5;
  scene.joints[1].axes[0].start = -0.9;
  scene.joints[1].mimics = {{.joint = 0, .axis = 0, .multiplier = -2, .offset = 0.1}};
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  step_engine(engine, 500);
  EXPECT_NEAR(engine.state().axes[0].position, 0.5, 1e-9);
  EXPECT_NEAR(engine.state().axes[1].position, -0.9, 1e-9);
}

TEST_P(Engines, CutsEffortsAtTheLimit) {
  Scene scene = joint_scene({JointType::kRevolute, {{0, 0, 1}}}, true);
  scene.joints[0].axes[0].effort = 0.01;
  for (const bool motor : {false, true}) {
    const auto engine_made = made_engine(scene, hand::stiff());
    Engine& engine = *engine_made;
    if (motor) {
      engine.set_motor(0, 0, 1000, 5);
    } else {
      engine.set_effort(0, 0, 5);
    }
    step_engine(engine, 500);
    EXPECT_NEAR(engine.state().axes[0].velocity, 0.01 / 0.036 * 0.5, 1e-4);
    EXPECT_NEAR(engine.state().axes[0].effort, 0.01, 1e-6);
  }
}

// A motor that holds an arm of 1 kg out level: the torque is its weight times the lever.
TEST_P(Engines, TellsTheEffortOfAMotor) {
  Scene scene = hand::scene();
  add_body(scene, hand::ball_mass(1, 0.3), {0.5, 0, 0});
  add_joint(scene, JointType::kRevolute, kWorld, 0, {}, {{0, 1, 0}});
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  engine.set_motor(0, 0, 0, 100);
  step_engine(engine, 200);
  EXPECT_NEAR(engine.state().axes[0].effort, -kWeight * 0.5, 1e-3);  // about y, x sinks
  EXPECT_NEAR(engine.state().axes[0].position, 0, 1e-6);
  engine.release(0, 0);
  step_engine(engine, 100);
  EXPECT_GT(engine.state().axes[0].position, 0.01);
  EXPECT_EQ(engine.state().axes[0].effort, 0);
}

// v(t) = v₀ exp(-d t/I) for d h/I = 0.02, and nothing blows up at 1e5 times that.
/// A joint gets its speed in one step.
void set_turning(Engine& engine) {
  engine.set_motor(0, 0, 1, 1e9);
  engine.step();
  engine.release(0, 0);
}

TEST_P(Engines, DampsForAnyDamping) {
  const double inertia = 0.036;
  for (const bool limited : {false, true}) {
    Scene scene = joint_scene({JointType::kRevolute, {{0, 0, 1}}}, true);
    simulate::SceneAxis& axis = scene.joints[0].axes[0];
    axis.damping = 0.72;
    if (limited) axis.upper = 3;
    const auto engine_made = made_engine(scene, hand::stiff());
    Engine& engine = *engine_made;
    set_turning(engine);
    const double begins = engine.state().axes[0].velocity;
    EXPECT_NEAR(begins, 1, 0.03);
    step_engine(engine, 50);
    const double exact = std::exp(-axis.damping * 0.05 / inertia);
    EXPECT_NEAR(engine.state().axes[0].velocity / begins, exact, 0.02 * exact + 1e-3);
    axis.damping = 7.2e4;
    const auto heavy_made = made_engine(scene, hand::stiff());
    Engine& heavy = *heavy_made;
    set_turning(heavy);
    step_engine(heavy, 50);
    EXPECT_NEAR(heavy.state().axes[0].velocity, 0, 1e-3);
  }
}

TEST_P(Engines, FrictionHoldsAndBrakes) {
  Scene scene = joint_scene({JointType::kRevolute, {{0, 0, 1}}}, true);
  scene.joints[0].axes[0].friction = 0.1;
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  engine.set_effort(0, 0, 0.09);
  step_engine(engine, 500);
  EXPECT_NEAR(engine.state().axes[0].position, 0, 1e-5);
  engine.set_effort(0, 0, 0.136);  // 0.036 N·m above
  step_engine(engine, 500);
  EXPECT_NEAR(engine.state().axes[0].velocity, 0.5, 2e-3);
}

// x(t) = x₀ cos(√(k/m) t).
TEST_P(Engines, SpringSwings) {
  Scene scene = joint_scene({JointType::kPrismatic, {{0, 0, 1}}}, true);
  scene.joints[0].axes[0].spring_stiffness = 100;
  scene.joints[0].axes[0].spring_reference = 0.1;
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  step_engine(engine, 314);  // half a period of √100 rad/s
  EXPECT_NEAR(engine.state().axes[0].position, 0.2, 1e-3);
}

TEST_P(Engines, MimicFollowsAndPushesBack) {
  Scene scene = hand::scene();
  scene.gravity = {};
  const auto one = add_body(scene, hand::ball_mass(1, 0.3), {});
  const auto two = add_body(scene, hand::ball_mass(1, 0.3), {2, 0, 0});
  add_joint(scene, JointType::kRevolute, kWorld, one, {}, {{0, 0, 1}});
  add_joint(scene, JointType::kRevolute, kWorld, two, {2, 0, 0}, {{0, 0, 1}});
  scene.joints[1].mimics = {{.joint = 0, .axis = 0, .multiplier = -2, .offset = 0.1}};
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  engine.set_effort(0, 0, 0.09);
  step_engine(engine, 1000);
  const auto& axes = engine.state().axes;
  EXPECT_NEAR(axes[1].position, -2 * axes[0].position + 0.1, 1e-3);
  // The leader turns both: 0.036 (1 + 2²) kg·m², begun by closing the offset.
  EXPECT_NEAR(axes[0].velocity, 0.09 / (0.036 * 5), 0.02);
}

TEST_P(Engines, ScrewGoesItsPitch) {
  for (const bool to_world : {false, true}) {
    Scene scene = joint_scene({JointType::kScrew, {{0, 0, 1}}}, to_world);
    scene.joints[0].screw_pitch = 0.05;
    const auto engine_made = made_engine(scene, hand::stiff());
    Engine& engine = *engine_made;
    engine.set_effort(0, 0, 0.3);
    step_engine(engine, 1000);
    const double turned = engine.state().axes[0].position;
    EXPECT_GT(turned, 1);
    EXPECT_NEAR(engine.state().bodies[1].p_WBcm.z, 0.05 * turned, 1e-3);
    // τ = (I + m p²) a
    EXPECT_NEAR(engine.state().axes[0].velocity, 0.3 / (0.036 + 0.0025), 0.1);
  }
}

TEST_P(Engines, GearboxTurnsTheOtherWay) {
  Scene scene = hand::scene();
  scene.gravity = {};
  const auto one = add_body(scene, hand::ball_mass(1, 0.3), {});
  const auto two = add_body(scene, hand::ball_mass(1, 0.3), {2, 0, 0});
  add_joint(scene, JointType::kRevolute, kWorld, one, {}, {{0, 0, 1}});
  add_joint(scene, JointType::kRevolute, kWorld, two, {2, 0, 0}, {{0, 0, 1}});
  add_joint(scene, JointType::kGearbox, one, two, {}, {{0, 0, 1}, {0, 0, 1}});
  scene.joints[2].gearbox_ratio = 4;
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  engine.set_effort(0, 0, 1.5);
  step_engine(engine, 1000);
  const auto& axes = engine.state().axes;
  EXPECT_GT(axes[0].position, 0.5);
  // SDF's gearbox_reference_body: theta_2 = -gearbox_ratio * theta_1.
  EXPECT_NEAR(axes[1].position, -4 * axes[0].position, 4e-3);
  EXPECT_NEAR(axes[2].position, axes[0].position, 1e-6);
}

TEST_P(Engines, FixedClosesALoop) {
  Scene scene = hand::scene();
  const auto one = add_body(scene, hand::ball_mass(1, 0.1), {0, 0, 1});
  add_joint(scene, JointType::kFixed, kWorld, one, {0, 0, 1}, {});
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  step_engine(engine, 500);
  EXPECT_NEAR(engine.state().bodies[0].p_WBcm.z, 1, 1e-4);
  EXPECT_LT(engine.state().anchor_error, 1e-4);
}

/// Two boxes of one model, one above the other, let fall on the ground.
Scene two_boxes() {
  Scene scene = hand::scene();
  for (const double z : {0.1, 0.31}) {
    const auto body = add_body(scene, hand::box_mass(1, {0.2, 0.2, 0.2}), {0, 0, z});
    add_shape(scene, body, mesh::Box{{0.2, 0.2, 0.2}});
  }
  add_ground(scene);
  return scene;
}

double Engines::upper_height(const Scene& scene) const {
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  step_engine(engine, 700);
  return engine.state().bodies[1].p_WBcm.z;
}

TEST_P(Engines, BodiesOfAModelTouchOnlyWhenTold) {
  Scene scene = two_boxes();
  EXPECT_NEAR(upper_height(scene), 0.1, 2e-3);  // through the other, onto the ground
  scene.bodies[0].self_collide = true;
  EXPECT_NEAR(upper_height(scene), 0.3, 2e-3);
  add_joint(scene, JointType::kPrismatic, 0, 1, {0, 0, 0.2}, {{0, 0, 1}});
  EXPECT_NEAR(upper_height(scene), 0.1, 2e-3);
}

TEST_P(Engines, BodiesOfTwoModelsTouchUnlessTheirMasksSayNo) {
  Scene scene = two_boxes();
  scene.models.push_back({.name = "other", .base = 1});
  scene.bodies[1].model = 1;
  EXPECT_NEAR(upper_height(scene), 0.3, 2e-3);
  scene.shapes[0].surface.collide_bitmask = 0b01;
  scene.shapes[1].surface.collide_bitmask = 0b10;
  EXPECT_NEAR(upper_height(scene), 0.1, 2e-3);
  scene.shapes[1].surface.collide_bitmask = 0b11;
  EXPECT_NEAR(upper_height(scene), 0.3, 2e-3);
  scene.shapes[1].surface.collide_without_contact = true;
  EXPECT_LT(upper_height(scene), -1);  // not even the ground holds it
}

// A body that hangs on the world by a joint meets the ground, but not its own model's still parts.
TEST_P(Engines, StillPartsOfAModelAreTheModels) {
  Scene scene = hand::scene();
  const auto arm = add_body(scene, hand::box_mass(1, {0.2, 0.2, 0.2}), {0, 0, 1});
  add_shape(scene, arm, mesh::Box{{0.2, 0.2, 0.2}});
  add_joint(scene, JointType::kPrismatic, kWorld, arm, {0, 0, 1}, {{0, 0, 1}});
  scene.links.push_back({.name = "robot::base", .body = kWorld, .model = 0});
  auto& base = add_shape(scene, kWorld, mesh::Box{{0.2, 0.2, 0.2}}, {{0, 0, 0.5}, {}});
  base.link = 1;
  add_ground(scene);
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  step_engine(engine, 1000);
  EXPECT_NEAR(engine.state().bodies[0].p_WBcm.z, 0.1, 2e-3);
}

/// The regular octahedron of radius 0.1, and a cube of side 0.2 as triangles.
mesh::TriangleMesh octahedron() {
  mesh::TriangleMesh mesh;
  mesh.positions = {{0.1, 0, 0},  {-0.1, 0, 0}, {0, 0.1, 0},
                    {0, -0.1, 0}, {0, 0, 0.1},  {0, 0, -0.1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

struct RestCase {
  std::string name;
  simulate::SceneShapeKind kind;
  double height;  // of its middle at rest
};

std::vector<RestCase> rest_cases() {
  const double upright = 0.1 / std::sqrt(3.0);  // of an octahedron on a face
  return {
      {"box", mesh::Box{{0.2, 0.3, 0.2}}, 0.1},        {"sphere", mesh::Sphere{0.1}, 0.1},
      {"cylinder", mesh::Cylinder{0.1, 0.2}, 0.1},     {"capsule", mesh::Capsule{0.1, 0.2}, 0.1},
      {"hull", simulate::ConvexHull{0}, 0.1},          {"mesh", simulate::TriangleSoup{0}, 0.1},
      {"octahedron", simulate::ConvexHull{1}, upright}};
}

simulate::Quaternion rest_rotation(const RestCase& rest) {
  if (rest.name == "capsule") return model::from_rpy(kHalfTurn / 2, 0, 0);
  if (rest.name != "octahedron") return {};
  // Turns (1, 1, 1) down onto -z.
  return model::from_axis_angle({1, -1, 0}, kHalfTurn - std::acos(1 / std::sqrt(3.0)));
}

struct FloorCase {
  simulate::EngineKind engine;
  std::string floor;
};

class RestsOn : public testing::TestWithParam<FloorCase> {
 protected:
  void SetUp() override {
    if (GetParam().engine == simulate::EngineKind::kOde) return;
    const std::string problem = simulate::mujoco_problem({});
    if (!problem.empty()) GTEST_SKIP() << problem;
  }

  void add_floor(Scene& scene) const {
    if (GetParam().floor == "plane") {
      add_ground(scene);
    } else if (GetParam().floor == "box") {
      add_shape(scene, kWorld, mesh::Box{{4, 4, 1}}, {{0, 0, -0.5}, {}});
    } else if (GetParam().floor == "mesh") {
      scene.meshes.push_back(mesh::mesh_of(mesh::Box{{4, 4, 1}}));
      const auto index = static_cast<std::uint32_t>(scene.meshes.size() - 1);
      add_shape(scene, kWorld, simulate::TriangleSoup{index}, {{0, 0, -0.5}, {}});
    } else {
      simulate::HeightGrid grid{.columns = 9, .rows = 9, .width = 4, .depth = 4, .heights = {}};
      grid.heights.assign(81, 0.0);
      add_shape(scene, kWorld, grid);
    }
  }
};

std::vector<FloorCase> floor_cases() {
  std::vector<FloorCase> cases;
  for (const char* floor : {"plane", "box", "mesh", "heights"}) {
    cases.push_back({simulate::EngineKind::kOde, floor});
    cases.push_back({simulate::EngineKind::kMujoco, floor});
  }
  return cases;
}

std::string floor_name(const testing::TestParamInfo<FloorCase>& parameter) {
  const bool ode = parameter.param.engine == simulate::EngineKind::kOde;
  return parameter.param.floor + (ode ? "_ode" : "_mujoco");
}

INSTANTIATE_TEST_SUITE_P(Floors, RestsOn, testing::ValuesIn(floor_cases()), floor_name);

// Each shape lies at its height, still, and the floor bears its weight.
TEST_P(RestsOn, EachShapeAtItsHeight) {
  for (const RestCase& rest : rest_cases()) {
    SCOPED_TRACE(rest.name);
    Scene scene = hand::scene();
    scene.meshes = {mesh::mesh_of(mesh::Box{{0.2, 0.2, 0.2}}), octahedron()};
    add_body(scene, hand::ball_mass(3, 0.1), {0.013, 0.017, rest.height}, rest_rotation(rest));
    add_shape(scene, 0, rest.kind);
    add_floor(scene);
    SolverSettings settings;
    settings.engine = GetParam().engine;
    const auto engine_made = simulate::make_engine(scene, settings);
    Engine& engine = *engine_made;
    step_engine(engine, 1000);
    Vector3 borne;
    for (int i = 0; i < 200; ++i) {
      engine.step(Forces::kAsked);
      for (const auto& contact : engine.state().contacts) {
        const bool on_a = scene.shapes[contact.shape_a].body != kWorld;
        borne = borne + (on_a ? 1.0 / 200 : -1.0 / 200) * contact.force;
        EXPECT_NEAR((on_a ? 1 : -1) * contact.normal.z, 1, 1e-3);
      }
    }
    EXPECT_NEAR(engine.state().bodies[0].p_WBcm.z, rest.height, 2e-3);
    EXPECT_NEAR(borne.z / (3 * kWeight), 1, 0.01);
    EXPECT_NEAR(borne.x, 0, 0.3);
    // What is round gets a push where it meets the edge between two triangles, and rolls on.
    const bool rolls = rest.name == "sphere" || rest.name == "capsule";
    EXPECT_NEAR(length(engine.state().bodies[0].v_WBcm), 0, rolls ? 2e-2 : 2e-3);
  }
}

// Row 0 is at the lowest y: a ball rolls down a slope that rises with y towards -y, and not along x.
TEST_P(Engines, HeightsRunAlongTheirAxes) {
  Scene scene = hand::scene();
  add_body(scene, hand::ball_mass(1, 0.1), {0, 0, 0.62});
  add_shape(scene, 0, mesh::Sphere{0.1});
  simulate::HeightGrid grid{.columns = 3, .rows = 5, .width = 4, .depth = 4, .heights = {}};
  for (int row = 0; row < 5; ++row) grid.heights.insert(grid.heights.end(), 3, 0.25 * row);
  add_shape(scene, kWorld, grid);
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  step_engine(engine, 1000);
  EXPECT_LT(engine.state().bodies[0].p_WBcm.y, -0.3);
  EXPECT_NEAR(engine.state().bodies[0].p_WBcm.x, 0, is_mujoco() ? 2e-3 : 1e-3);
}

TEST_P(Engines, TouchMovesNothing) {
  Scene scene = two_boxes();
  scene.bodies[0].X_WB.translation.z = 0.09;
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  engine.touch();
  ASSERT_FALSE(engine.state().contacts.empty());
  EXPECT_NEAR(engine.state().contacts[0].depth, 0.01, 1e-9);
  EXPECT_EQ(engine.state().time, 0);
  EXPECT_EQ(engine.state().bodies[0].p_WBcm.z, 0.09);
}

// What would end the process becomes an exception, and the next engine works.
TEST_P(Engines, ErrorsAreExceptions) {
  Scene bad = hand::scene();
  add_body(bad, {1, {}, {.ixx = -1, .iyy = 1, .izz = 1}}, {});
  EXPECT_THROW(made_engine(bad, hand::stiff()), simulate::EngineError);
  Scene axis = joint_scene({JointType::kRevolute, {{0, 0, 0}}}, true);
  EXPECT_THROW(made_engine(axis, hand::stiff()), simulate::EngineError);
  Scene good = two_boxes();
  EXPECT_NEAR(upper_height(good), 0.1, 2e-3);
}

}  // namespace
}  // namespace rigor
