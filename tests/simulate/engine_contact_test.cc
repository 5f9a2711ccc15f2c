// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Friction along a direction, and contacts that give way.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "simulate/engines.h"
#include "simulate/hand_scene.h"

namespace rigor {
namespace {

using hand::add_body;
using hand::add_ground;
using hand::add_shape;
using hand::Scene;
using hand::Vector3;
using simulate::Engine;
using simulate::kWorld;
using simulate::SolverSettings;

constexpr double kContactWeight = 9.8;  // N/kg

class Contacts : public test::Engines {};

INSTANTIATE_TEST_SUITE_P(Each, Contacts,
                         testing::Values(simulate::EngineKind::kOde, simulate::EngineKind::kMujoco),
                         test::engine_name);

void step_contacts(Engine& engine, int steps) {
  for (int i = 0; i < steps; ++i) engine.step();
}

// fdir1 turns with the link: the small mu acts along it, and the large across.
TEST_P(Contacts, SlipsAlongItsFirstDirection) {
  for (const double yaw : {0.0, 1.5707963267948966}) {
    Scene scene = hand::scene();
    add_body(scene, hand::box_mass(1, {0.4, 0.4, 0.2}), {0, 0, 0.1}, model::from_rpy(0, 0, yaw));
    auto& surface = add_shape(scene, 0, mesh::Box{{0.4, 0.4, 0.2}}).surface;
    surface.mu = 0.1;
    surface.mu2 = 1;
    surface.fdir1 = {1, 0, 0};
    add_ground(scene);
    scene.gravity = {3, 0, -9.8};  // pulls along x with 3, mu holds 0.98 or 9.8
    const auto engine_made = made_engine(scene, hand::stiff());
    Engine& engine = *engine_made;
    step_contacts(engine, 500);
    const double v = engine.state().bodies[0].v_WBcm.x;
    if (yaw == 0) {
      EXPECT_NEAR(v, (3 - 0.98) * 0.5, 0.01);
    } else {
      EXPECT_NEAR(v, 0, 1e-3);
    }
  }
}

// The slips of both surfaces add up: v = slip · force. The ball is too slow to turn.
TEST_P(Contacts, SlipsByForce) {
  if (is_mujoco()) GTEST_SKIP() << "MuJoCo has no friction that gives way to force";
  Scene scene = hand::scene();
  add_body(scene, {1, {}, {.ixx = 1e6, .iyy = 1e6, .izz = 1e6}}, {0, 0, 0.1});
  add_shape(scene, 0, mesh::Sphere{0.1});
  add_ground(scene);
  for (const std::size_t i : {0U, 1U}) {
    scene.shapes[i].surface.slip1 = i == 0 ? 0.2 : 0.1;
    scene.shapes[i].surface.slip2 = scene.shapes[i].surface.slip1;
  }
  scene.gravity = {1.5, 0, -9.8};
  const auto engine_made = made_engine(scene, hand::stiff());
  Engine& engine = *engine_made;
  step_contacts(engine, 3000);
  EXPECT_NEAR(engine.state().bodies[0].v_WBcm.x, 0.3 * 1.5, 2e-3);
}

// kp in series and kd summed: a weight sinks m g / kp into the ground.
TEST_P(Contacts, SinksByItsStiffness) {
  if (is_mujoco()) GTEST_SKIP() << "MuJoCo's contacts have no stiffness in N/m";
  Scene scene = hand::scene();
  add_body(scene, hand::ball_mass(1, 0.1), {0, 0, 0.1});
  add_shape(scene, 0, mesh::Sphere{0.1});
  add_ground(scene);
  for (auto& shape : scene.shapes) {
    shape.surface.kp = 4000;
    shape.surface.kd = 50;
  }
  SolverSettings settings = hand::stiff();
  settings.stiffness = true;
  settings.surface_layer = 0;
  settings.max_correcting_velocity = 100;
  const auto engine_made = made_engine(scene, settings);
  Engine& engine = *engine_made;
  step_contacts(engine, 2000);
  EXPECT_NEAR(0.1 - engine.state().bodies[0].p_WBcm.z, kContactWeight / 2000, 1e-4);
}

}  // namespace
}  // namespace rigor
