// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What motors put in, and how fast what they move is.

#include <algorithm>
#include <cmath>
#include <string>

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

/// A wheel of 0.05 kg and 0.033 m: a damper of 1 N·m·s/rad stops it within a thirtieth of a step.
Scene damped_wheel() {
  Scene scene = hand::scene();
  scene.gravity = {};
  add_body(scene, hand::drum_mass(0.05, 0.033, 0.015), {});
  add_joint(scene, JointType::kRevolute, kWorld, 0, {}, {{0, 0, 1}});
  scene.joints[0].axes[0].damping = 1;
  scene.joints[0].axes[0].effort = 1;
  return scene;
}

// What the motor gives is what the damper takes: 1 N·m at 1 rad/s.
TEST_P(Motors, AMotorTurnsATightDamperAsFastAsItsEffortLasts) {
  const Scene scene = damped_wheel();
  for (const double told : {18.3, 0.5}) {
    const auto engine_made = made_engine(scene, simulate::SolverSettings{});
    Engine& engine = *engine_made;
    engine.set_motor(0, 0, told, simulate::kInfinity);
    for (int i = 0; i < 200; ++i) engine.step(Forces::kAsked);
    EXPECT_NEAR(engine.state().axes[0].velocity, std::min(told, 1.0), is_mujoco() ? 0.01 : 1e-3)
        << told;
  }
}

/// A carriage of 10 g on rails upright, which carries a ball of 10 kg that hangs on a hinge below it.
Scene sprung_carriage(double stiffness, double reference) {
  Scene scene = hand::scene();
  add_body(scene, hand::ball_mass(0.01, 0.05), {0, 0, 1});
  add_body(scene, hand::ball_mass(10, 0.05), {0, 0, 0.5});
  add_joint(scene, JointType::kPrismatic, kWorld, 0, {0, 0, 1}, {{0, 0, 1}});
  add_joint(scene, JointType::kRevolute, 0, 1, {0, 0, 1}, {{0, 1, 0}});
  scene.joints[0].axes[0].spring_stiffness = stiffness;
  scene.joints[0].axes[0].spring_reference = reference;
  scene.joints[0].axes[0].damping = 2000;
  return scene;
}

// k h²/m of the carriage is 10: a force would be unstable, or a tenth of the spring. It sags by (m + M) g/k.
TEST_P(Motors, ASpringIsAsStiffAsItIsWrittenHoweverLightWhatItMeets) {
  if (is_mujoco()) GTEST_SKIP() << "MuJoCo has springs of its own";
  for (const simulate::Solver solver : {simulate::Solver::kQuick, simulate::Solver::kDantzig}) {
    simulate::SolverSettings settings;
    settings.solver = solver;
    for (const double reference : {0.0, 0.05}) {
      const Scene scene = sprung_carriage(1e5, reference);
      const auto engine_made = made_engine(scene, settings);
      Engine& engine = *engine_made;
      for (int i = 0; i < 2000; ++i) engine.step(Forces::kAsked);
      const double sag = 10.01 * 9.8 / 1e5;
      // A ratio of masses of 1000 is more than 200 sweeps bring together.
      const double loose = solver == simulate::Solver::kQuick ? 0.15 : 0.02;
      EXPECT_NEAR(engine.state().axes[0].position, reference - sag, loose * sag) << reference;
    }
  }
}

// The spring of a hinge between two bodies, and that of a slider off their centers, turn nothing as a whole. Pulling at
// the centers would leave 0.1 kg·m²/s.
TEST_P(Motors, AStiffSpringKeepsTheMomentum) {
  if (is_mujoco()) GTEST_SKIP() << "MuJoCo has springs of its own";
  for (const JointType type : {JointType::kPrismatic, JointType::kRevolute}) {
    Scene scene = hand::scene();
    scene.gravity = {};
    add_body(scene, hand::ball_mass(0.01, 0.02), {0, 0, 0});
    add_body(scene, hand::ball_mass(10, 0.2), {0.3, 0.5, 0});
    add_joint(scene, type, 1, 0, {0, 0.2, 0},
              {type == JointType::kPrismatic ? Vector3{1, 0, 0} : Vector3{0, 0, 1}});
    scene.joints[0].axes[0].spring_stiffness = 1e6;
    scene.joints[0].axes[0].spring_reference = 0.1;
    scene.joints[0].axes[0].damping = 100;
    const auto engine_made = made_engine(scene, exact());
    Engine& engine = *engine_made;
    for (int i = 0; i < 1000; ++i) engine.step(Forces::kAsked);
    EXPECT_NEAR(engine.state().axes[0].position, 0.1, 1e-3);
    Vector3 linear, angular;
    for (std::size_t i = 0; i < 2; ++i) {
      const simulate::BodyState& body = engine.state().bodies[i];
      const mass::MassProperties& m = scene.bodies[i].mass;
      linear = linear + m.mass * body.v_WBcm;
      angular = angular + m.about_com.izz * body.w_WB + m.mass * cross(body.p_WBcm, body.v_WBcm);
    }
    EXPECT_NEAR(model::length(linear), 0, 1e-3);
    EXPECT_NEAR(model::length(angular), 0, 1e-3);
  }
}

/// A rod of 2 kg and 1 m on a hinge at its end: 9.8 N·m.
Scene rod() {
  Scene scene = hand::scene();
  add_body(scene, hand::box_mass(2, {1, 0.05, 0.05}), {0.5, 0, 1});
  add_joint(scene, JointType::kRevolute, kWorld, 0, {0, 0, 1}, {{0, 1, 0}});
  return scene;
}

/// How far the rod (9.8 N·m down) has gone in two seconds of a motor, and what the motor gave in the end.
struct Moved {
  double by = 0;
  double effort = 0;
};
Moved moved(Engine& engine, double told) {
  engine.set_motor(0, 0, 0, simulate::kInfinity);
  for (int i = 0; i < 500; ++i) engine.step(Forces::kAsked);
  for (int i = 0; i < 1000; ++i) {
    engine.set_motor(0, 0, told * std::min(1.0, i / 500.0), simulate::kInfinity);
    engine.step(Forces::kAsked);
  }
  return {engine.state().axes[0].position, engine.state().axes[0].effort};
}

// A joint's friction helps a motor to hold, and is in its way when it drives. Up is negative.
TEST_P(Motors, FrictionHoldsWithAMotorAndWorksAgainstIt) {
  if (is_mujoco()) GTEST_SKIP() << "MuJoCo has one row for the motor";
  struct Case {
    double friction, effort, told, by;
  };
  const double sunk = 1;  // and more
  for (const Case& c : {
           Case{15, 0, 0, 0},           // friction alone bears it
           Case{15, 5, 0, 0},           // 20 against 9.8
           Case{6, 5, 0, 0},            // 11 against 9.8: neither alone
           Case{4, 5, 0, sunk},         // 9 against 9.8
           Case{15, 20, -0.1, 0},       // 9.8 + 15 to raise it
           Case{15, 30, -0.1, -0.075},  // half a second of ramp, half of cruise
           Case{15, 4, 0.1, 0},         // 9.8 + 4 do not push it down
           Case{15, 8, 0.1, 0.075},     // and 9.8 + 8 do
       }) {
    for (const simulate::Solver solver : {simulate::Solver::kQuick, simulate::Solver::kDantzig}) {
      Scene scene = rod();
      scene.joints[0].axes[0].friction = c.friction;
      scene.joints[0].axes[0].effort = c.effort;
      simulate::SolverSettings settings;
      settings.solver = solver;
      const auto engine_made = made_engine(scene, settings);
      const Moved seen = moved(*engine_made, c.told);
      SCOPED_TRACE(std::to_string(c.friction) + " " + std::to_string(c.effort));
      if (c.by == sunk) {
        EXPECT_GT(seen.by, 0.1);
      } else {
        EXPECT_NEAR(seen.by, c.by, 0.003);
      }
      if (c.by < 0) {
        EXPECT_NEAR(seen.effort, -(9.8 * std::cos(seen.by) + 15), 0.1);
      }
    }
  }
}

}  // namespace
}  // namespace rigor
