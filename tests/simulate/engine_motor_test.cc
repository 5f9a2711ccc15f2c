// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What motors put in, and how fast what they move is.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <rigor/simulate/engine/ode/ode_engine.h>

#include "simulate/engines.h"
#include "simulate/hand_scene.h"

namespace rigor {
namespace {

using hand::add_body;
using hand::add_joint;
using hand::Scene;
using hand::Vector3;
using model::JointType;
using simulate::Engine;
using simulate::Forces;
using simulate::kWorld;

class Motors : public test::Engines {};

INSTANTIATE_TEST_SUITE_P(Each, Motors,
                         testing::Values(simulate::EngineKind::kOde, simulate::EngineKind::kMujoco),
                         test::engine_name);

/// Two boxes side by side on a slider.
Scene sliding_pair() {
  Scene scene = hand::scene();
  scene.gravity = {};
  add_body(scene, hand::box_mass(1, {0.2, 0.3, 0.4}), {0, 0, 0});
  add_body(scene, hand::box_mass(2, {0.2, 0.3, 0.4}), {0.3, 1, 0});
  add_joint(scene, JointType::kPrismatic, 0, 1, {0, 0.5, 0}, {{1, 0, 0}});
  return scene;
}

// Both turn as one about the first: what one sees of the other stands still.
TEST_P(Motors, ASlidersSpeedIsAsSeenFromItsTurningSide) {
  if (is_mujoco()) GTEST_SKIP() << "in MuJoCo a joint decides how fast what it carries is";
  const Scene scene = sliding_pair();
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  engine.set_velocity(0, {}, {0, 0, 3});
  engine.set_velocity(1, {-3, 0.9, 0}, {0, 0, 3});
  EXPECT_NEAR(engine.state().axes[0].velocity, 0, 1e-12);
  engine.set_velocity(1, {-3 + 0.5, 0.9, 0}, {0, 0, 3});
  EXPECT_NEAR(engine.state().axes[0].velocity, 0.5, 1e-12);
}

simulate::SolverSettings exact() {
  simulate::SolverSettings settings = hand::stiff();
  settings.solver = simulate::Solver::kDantzig;
  return settings;
}

/// A ball of 2 kg, 0.5 m beside a hinge on the world's side.
Scene lever() {
  Scene scene = hand::scene();
  add_body(scene, hand::ball_mass(2, 0.05), {0.5, 0, 1});
  add_joint(scene, JointType::kRevolute, kWorld, 0, {0, 0, 1}, {{0, 1, 0}});
  return scene;
}

// At rest the spring bears the weight: k q = m g l cos q. The stiffer is beyond what an explicit one can be.
TEST_P(Motors, AServoSagsAsASpringAndIsStableHoweverStiff) {
  const Scene scene = lever();
  for (const double k : {400.0, 4e5}) {
    const auto engine_made = made_engine(scene, exact());
    Engine& engine = *engine_made;
    for (int i = 0; i < 3000; ++i) {
      engine.set_servo(
          0, 0, {.stiffness = k, .damping = k / 20, .error = -engine.state().axes[0].position});
      engine.step(Forces::kAsked);
    }
    const double q = engine.state().axes[0].position;
    EXPECT_NEAR(k * q, 2 * 9.8 * 0.5 * std::cos(q), 0.02) << k;
    EXPECT_NEAR(engine.state().axes[0].velocity, 0, 1e-6) << k;
  }
}

TEST_P(Motors, AServoGivesNoMoreThanItsEffort) {
  const Scene scene = lever();
  const auto engine_made = made_engine(scene, exact());
  Engine& engine = *engine_made;
  for (int i = 0; i < 100; ++i) {
    engine.set_servo(
        0, 0,
        {.stiffness = 1e5, .damping = 1e3, .error = -engine.state().axes[0].position, .effort = 3});
    engine.step(Forces::kAsked);
  }
  // Read off the joint's force, whose lever is that of the step before.
  EXPECT_NEAR(std::abs(engine.state().axes[0].effort), 3, 0.01);
  // It falls with (m g l - 3)/(m l² + 2/5 m r²) for a tenth of a second.
  EXPECT_NEAR(engine.state().axes[0].position, 0.5 * (9.8 - 3) / 0.502 * 0.01, 0.001);
}

// What a motor puts in is what the two have more, also while they turn.
TEST_P(Motors, AMotorsWorkIsTheEnergyThatComesIn) {
  if (is_mujoco()) GTEST_SKIP() << "in MuJoCo a joint decides how fast what it carries is";
  const Scene scene = sliding_pair();
  simulate::SolverSettings fine = hand::stiff();
  fine.step = 1e-4;
  fine.solver = simulate::Solver::kDantzig;
  const auto engine_made = made_engine(scene, fine);
  Engine& engine = *engine_made;
  engine.set_velocity(0, {}, {0, 0, 3});
  engine.set_velocity(1, {-3, 0.9, 0}, {0, 0, 3});
  const auto energy = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const simulate::BodyState& body = engine.state().bodies[i];
      const mass::MassProperties& m = scene.bodies[i].mass;
      const Vector3& w = body.w_WB;  // about z only, as all is flat
      sum += (m.mass * dot(body.v_WBcm, body.v_WBcm) + m.about_com.izz * w.z * w.z) / 2;
    }
    return sum;
  };
  const double before = energy();
  engine.set_motor(0, 0, -4, 5);
  for (int i = 0; i < 2000; ++i) engine.step(Forces::kAsked);
  EXPECT_GT(std::abs(energy() - before), 0.5);
  EXPECT_NEAR(engine.state().motor_work, energy() - before, 0.01 * before);
}

// A motor of 1 N·m under a weight of 4.9 N·m: the stop takes the fall, and the motor never more than its 1.
TEST_P(Motors, WhatAStopDoesIsNotTheMotors) {
  Scene scene = hand::scene();
  add_body(scene, hand::ball_mass(1, 0.1), {0.5, 0, 0});
  add_joint(scene, JointType::kRevolute, kWorld, 0, {}, {{0, 1, 0}});
  scene.joints[0].axes[0].upper = 1;
  scene.joints[0].axes[0].effort = 1;
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  double most = 0;
  for (const double told : {0.5, -0.5}) {
    engine.set_motor(0, 0, told, 5);
    for (int i = 0; i < 1500; ++i) {
      engine.step(Forces::kAsked);
      most = std::max(most, std::abs(engine.state().axes[0].effort));
    }
  }
  EXPECT_NEAR(engine.state().axes[0].position, 1, 0.01);
  EXPECT_LE(most, 1);
}

// Arms are written with half a turn to both sides: leaving such a stop, a strong motor keeps to its speed.
TEST_P(Motors, AMotorLeavesAStopAtHalfATurnAsItIsTold) {
  for (const double upper : {3.14159265359, simulate::kInfinity}) {
    Scene scene = hand::scene();
    scene.gravity = {};
    add_body(scene, hand::ball_mass(1, 0.1), {0.5, 0, 0});
    add_joint(scene, JointType::kRevolute, kWorld, 0, {}, {{0, 1, 0}});
    scene.joints[0].axes[0].lower = -3.14159265359;
    scene.joints[0].axes[0].upper = upper;
    const auto engine_made = made_engine(scene, hand::stiff());
    Engine& engine = *engine_made;
    engine.set_motor(0, 0, -1, 50);
    for (int i = 0; i < 3500; ++i) engine.step(Forces::kAsked);
    EXPECT_NEAR(engine.state().axes[0].position, -3.14159265359, 1e-3) << upper;
    engine.set_motor(0, 0, 1, 50);
    for (int i = 0; i < 1000; ++i) engine.step(Forces::kAsked);
    EXPECT_NEAR(engine.state().axes[0].velocity, 1, 1e-3) << upper;
    EXPECT_NEAR(engine.state().axes[0].position, -2.14159265359, 0.01) << upper;
  }
}

// A lift of a hundred kilograms: 981 N against its motor, which the world's constraint force mixing of 1e-5 (m/s)/N
// would let sink by most of what it lifts.
TEST_P(Motors, ASlowStrongMotorKeepsToItsSpeedUnderLoad) {
  Scene scene = hand::scene();
  add_body(scene, hand::ball_mass(100, 0.2), {0, 0, 1});
  add_joint(scene, JointType::kPrismatic, kWorld, 0, {0, 0, 1}, {{0, 0, 1}});
  scene.joints[0].axes[0].effort = 10000;
  scene.joints[0].axes[0].velocity = 0.013;
  const auto engine_made = made_engine(scene, simulate::SolverSettings{});
  Engine& engine = *engine_made;
  engine.set_motor(0, 0, 0.013, simulate::kInfinity);
  for (int i = 0; i < 1000; ++i) engine.step(Forces::kAsked);
  EXPECT_NEAR(engine.state().axes[0].position, 0.013, 0.02 * 0.013);
}

}  // namespace
}  // namespace rigor
