// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The engine against closed forms. Tolerances are what ODE's own integrator keeps at 1 ms.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rigor/simulate/commander.h>
#include <rigor/simulate/engine/engine.h>
#include <rigor/simulate/engine/mujoco/mujoco_engine.h>

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
using simulate::kWorld;
using simulate::make_engine;
using simulate::SolverSettings;

constexpr double kG = 9.8;
constexpr double kPi = 3.14159265358979323846;

SolverSettings with(simulate::Solver solver) {
  SolverSettings settings = hand::stiff();
  settings.solver = solver;
  // The exact solver divides by zero without any.
  if (solver == simulate::Solver::kDantzig) settings.cfm = 1e-9;
  return settings;
}

enum class Stepped { kQuick, kDantzig, kMujoco };

class Physics : public testing::TestWithParam<Stepped> {
 protected:
  void SetUp() override {
    if (!is_mujoco()) return;
    const std::string problem = simulate::mujoco_problem({});
    if (!problem.empty()) GTEST_SKIP() << problem;
  }

  bool is_mujoco() const { return GetParam() == Stepped::kMujoco; }

  SolverSettings settings() const {
    SolverSettings settings = with(GetParam() == Stepped::kDantzig ? simulate::Solver::kDantzig
                                                                   : simulate::Solver::kQuick);
    if (is_mujoco()) settings.engine = simulate::EngineKind::kMujoco;
    return settings;
  }
};

std::string solver_name(const testing::TestParamInfo<Stepped>& parameter) {
  switch (parameter.param) {
    case Stepped::kQuick: return "Quick";
    case Stepped::kDantzig: return "Dantzig";
    case Stepped::kMujoco: break;
  }
  return "Mujoco";
}

INSTANTIATE_TEST_SUITE_P(Solvers, Physics,
                         testing::Values(Stepped::kQuick, Stepped::kDantzig, Stepped::kMujoco),
                         solver_name);

void run_for(Engine& engine, double seconds, const SolverSettings& settings) {
  const auto steps = static_cast<int>(std::lround(seconds / settings.step));
  for (int i = 0; i < steps; ++i) engine.step();
}

// Semi-implicit Euler: after n steps z = -g h² n (n + 1)/2.
TEST_P(Physics, FallsFreely) {
  Scene scene = hand::scene();
  add_body(scene, hand::ball_mass(2, 0.1), {0, 0, 10});
  const auto engine_made = make_engine(scene, settings());
  Engine& engine = *engine_made;
  run_for(engine, 1, settings());
  EXPECT_NEAR(engine.state().bodies[0].p_WBcm.z - 10, -kG * 1 * (1 + 0.001) / 2, 1e-9);
  EXPECT_NEAR(engine.state().bodies[0].v_WBcm.z, -kG, 1e-9);
}

TEST_P(Physics, FliesAsFarAsItWasThrown) {
  Scene scene = hand::scene();
  add_body(scene, hand::ball_mass(2, 0.1), {});
  const auto engine_made = make_engine(scene, settings());
  Engine& engine = *engine_made;
  engine.set_velocity(0, {3, 0, 4}, {});
  run_for(engine, 1, settings());
  EXPECT_NEAR(engine.state().bodies[0].p_WBcm.x, 3, 1e-12);
  EXPECT_NEAR(engine.state().bodies[0].p_WBcm.z, 4 - kG * (1 + 0.001) / 2, 1e-9);
}

/// Of a pendulum of amplitude a, over that of a small one: 1/agm(1, cos(a/2)) (C. F. Gauss).
double period_factor(double amplitude) {
  double a = 1;
  double b = std::cos(amplitude / 2);
  for (int i = 0; i < 20; ++i) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return 1 / a;
}

// A rod of 1 m with its end on a hinge, let go at an amplitude; the time between zero crossings,
// interpolated, is half a period.
TEST_P(Physics, PendulumSwingsWithItsPeriod) {
  const double length = 1;
  for (const double amplitude : {0.1, 1.0, 2.5}) {
    Scene scene = hand::scene();
    mass::MassProperties rod = hand::box_mass(1, {0.02, 0.02, length});
    rod.com = {0, 0, -length / 2};  // B is at the hinge
    add_body(scene, rod, {}, model::from_rpy(0, amplitude, 0));
    add_joint(scene, JointType::kRevolute, kWorld, 0, {}, {{0, 1, 0}});
    const auto engine_made = make_engine(scene, settings());
    Engine& engine = *engine_made;
    const double about_hinge = rod.about_com.iyy + length * length / 4;
    const double small = 2 * kPi * std::sqrt(about_hinge / (kG * length / 2));
    std::vector<double> crossings;
    double before = amplitude;
    while (crossings.size() < 3 && engine.state().time < 20) {
      engine.step();
      const double q = amplitude + engine.state().axes[0].position;
      if (before * q <= 0 && before != q) {
        crossings.push_back(engine.state().time - 0.001 * q / (q - before));
      }
      before = q;
    }
    ASSERT_EQ(crossings.size(), 3U);
    const double exact = small * period_factor(amplitude);
    EXPECT_NEAR((crossings[2] - crossings[0]) / exact, 1, 5e-4) << amplitude;
  }
}

// The table tilts, by gravity.
TEST_P(Physics, BoxSticksBelowTheFrictionAngleAndSlidesAbove) {
  for (const double degrees : {20.0, 30.0}) {
    for (const double mu : {0.3, 0.5, 0.7}) {
      const double angle = degrees * kPi / 180;
      Scene scene = hand::scene();
      add_body(scene, hand::box_mass(1, {0.4, 0.4, 0.2}), {0, 0, 0.1});
      simulate::ContactSurface& surface = add_shape(scene, 0, mesh::Box{{0.4, 0.4, 0.2}}).surface;
      surface.mu = mu;
      surface.mu2 = mu;
      add_ground(scene);
      scene.gravity = {kG * std::sin(angle), 0, -kG * std::cos(angle)};
      const auto engine_made = make_engine(scene, settings());
      Engine& engine = *engine_made;
      run_for(engine, 2, settings());
      const double pull = kG * (std::sin(angle) - mu * std::cos(angle));
      const double x = engine.state().bodies[0].p_WBcm.x;
      const double v = engine.state().bodies[0].v_WBcm.x;
      if (pull <= 0) {
        EXPECT_NEAR(x, 0, 1e-4) << degrees << " " << mu;
      } else {
        // MuJoCo's friction is within half a hundredth of what it should be; what is left of the pull is small.
        const double band = is_mujoco() ? 0.005 * mu * kG * std::cos(angle) / pull : 0;
        EXPECT_NEAR(v / (2 * pull), 1, 2e-3 + band) << degrees << " " << mu;
        EXPECT_NEAR(x / (2 * pull), 1, 4e-3 + band) << degrees << " " << mu;
      }
    }
  }
}

// Contacts that give way by 1e-5 (m/s)/N and are corrected by 0.1 m/s at most let 20 t sink by 0.4 m each second. What
// is scaled to the mass comes to rest in the surface layer, deeper by cfm F/4 h/erp, a fiftieth of a millimeter.
TEST_P(Physics, WhatIsHeavyDoesNotSinkWithoutEnd) {
  if (is_mujoco()) GTEST_SKIP() << "MuJoCo's contacts are relative to the mass";
  for (const double mass : {2000.0, 20000.0}) {
    Scene scene = hand::scene();
    add_body(scene, hand::box_mass(mass, {1, 1, 1}), {0, 0, 0.5});
    add_shape(scene, 0, mesh::Box{{1, 1, 1}});
    add_ground(scene);
    SolverSettings settled = settings();
    settled.cfm = std::min(SolverSettings{}.cfm, softest_cfm(scene));
    const auto engine = make_engine(scene, settled);
    run_for(*engine, 2, settled);
    const double give = settled.cfm * mass * kG / 4 * settled.step / settled.erp;
    const simulate::BodyState& box = engine->state().bodies[0];
    EXPECT_NEAR(0.5 - box.p_WBcm.z, settled.surface_layer + give, 2e-5) << mass;
    EXPECT_NEAR(box.v_WBcm.z, 0, 1e-4) << mass;
  }
}

TEST_P(Physics, BallAndCylinderRollDown) {
  const double r = 0.1;
  const double angle = 10 * kPi / 180;
  const auto roll = [&](const simulate::SceneShapeKind& kind, const mass::MassProperties& mass) {
    Scene scene = hand::scene();
    add_body(scene, mass, {0, 0, r}, model::from_rpy(-kPi / 2, 0, 0));  // its axis along y
    add_shape(scene, 0, kind);
    add_ground(scene);
    scene.gravity = {kG * std::sin(angle), 0, -kG * std::cos(angle)};
    const auto engine_made = make_engine(scene, settings());
    Engine& engine = *engine_made;
    run_for(engine, 2, settings());
    return engine.state().bodies[0];
  };
  const auto ball = roll(mesh::Sphere{r}, hand::ball_mass(1, r));
  EXPECT_NEAR(ball.p_WBcm.x / (kG * std::sin(angle) / 1.4 * 2), 1, 1e-3);
  EXPECT_NEAR(ball.w_WB.y * r / ball.v_WBcm.x, 1, 1e-3);
  const auto cylinder = roll(mesh::Cylinder{r, 0.1}, hand::drum_mass(1, r, 0.1));
  EXPECT_NEAR(cylinder.p_WBcm.x / (kG * std::sin(angle) / 1.5 * 2), 1, 1e-3);
  EXPECT_NEAR(cylinder.w_WB.y * r / cylinder.v_WBcm.x, 1, 1e-3);
  EXPECT_NEAR(cylinder.p_WBcm.y, 0, 1e-4);
}

struct Motion {
  double energy = 0;
  Vector3 momentum;
};

Motion motion_of(const simulate::BodyState& body, const mass::MassProperties& mass) {
  const mass::Inertia& I = mass.about_com;
  const Vector3 w = model::rotate(model::conjugate(body.R_WB), body.w_WB);
  const Vector3 L{I.ixx * w.x + I.ixy * w.y + I.ixz * w.z, I.ixy * w.x + I.iyy * w.y + I.iyz * w.z,
                  I.ixz * w.x + I.iyz * w.y + I.izz * w.z};
  return {dot(w, L) / 2, model::rotate(body.R_WB, L)};
}

/// Of a body of moments A < B < C that turns about the middle one, disturbed by the share `e`: the time
/// between two flips is 2 K(k)/p, about ln(16/(e²…))/p; here it is only counted (the reference: 12).
TEST_P(Physics, FreeBodyFlipsAndKeepsItsMomentum) {
  Scene scene = hand::scene();
  const mass::MassProperties body{
      .mass = 1, .com = {}, .about_com = {.ixx = 1, .iyy = 2, .izz = 3}};
  add_body(scene, body, {});
  scene.gravity = {};
  const auto engine_made = make_engine(scene, settings());
  Engine& engine = *engine_made;
  engine.set_velocity(0, {}, {0.01, 5, 0});
  const Motion before = motion_of(engine.state().bodies[0], body);
  int flips = 0;
  double facing = 1;
  for (int i = 0; i < 20'000; ++i) {
    engine.step();
    const double along = model::rotate(engine.state().bodies[0].R_WB, {0, 1, 0}).y;
    if (along * facing < -0.5) {
      facing = -facing;
      ++flips;
    }
  }
  const Motion after = motion_of(engine.state().bodies[0], body);
  EXPECT_GE(flips,
            is_mujoco() ? 3 : 9);  // the longer between two flips, the less its disturbance grows
  EXPECT_LE(flips, 13);
  EXPECT_NEAR(after.energy / before.energy, 1, 0.1);
  EXPECT_NEAR(length(after.momentum - before.momentum) / length(before.momentum), 0, 0.05);
}

TEST_P(Physics, BallBouncesAsHighAsItsRestitutionSays) {
  const double r = 0.1;
  for (const double e : {0.0, 0.5, 0.8, 1.0}) {
    Scene scene = hand::scene();
    add_body(scene, hand::ball_mass(1, r), {0, 0, 1 + r});
    add_shape(scene, 0, mesh::Sphere{r});
    add_ground(scene);
    for (auto& shape : scene.shapes) {
      shape.surface.restitution = e;
      shape.surface.bounce_threshold = 0.01;
    }
    const auto engine_made = make_engine(scene, settings());
    Engine& engine = *engine_made;
    double top = 0;
    bool bounced = false;
    while (engine.state().time < 1.2) {
      engine.step();
      const auto& body = engine.state().bodies[0];
      if (body.v_WBcm.z >= 0) bounced = true;
      if (bounced) top = std::max(top, body.p_WBcm.z - r);
      if (bounced && body.v_WBcm.z < -0.5) break;
    }
    ASSERT_TRUE(bounced);
    // MuJoCo's is a spring and a damper that pull at nothing.
    EXPECT_NEAR(top, e * e, is_mujoco() ? 0.05 : 0.02) << e;
  }
}

// Ten rods of 1 kg and a load of 50 kg hang in a row, pushed sideways.
TEST_P(Physics, ChainHoldsTogether) {
  Scene scene = hand::scene();
  const double length = 0.2;
  for (int i = 0; i < 10; ++i) {
    const double top = -i * length;
    const double mass = i == 9 ? 50 : 0.5;
    add_body(scene, hand::box_mass(mass, {0.04, 0.04, length}), {0, 0, top - length / 2});
    add_joint(scene, JointType::kRevolute, i == 0 ? kWorld : static_cast<std::uint32_t>(i - 1),
              static_cast<std::uint32_t>(i), {0, 0, top}, {{0, 1, 0}});
  }
  const auto engine_made = make_engine(scene, settings());
  Engine& engine = *engine_made;
  engine.push(9, {20, 0, 0}, {});
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    engine.step();
    worst = std::max(worst, engine.state().anchor_error);
  }
  EXPECT_LT(worst, 2e-3);
  EXPECT_EQ(worst > 0, !is_mujoco());  // its joints cannot come apart
}

// Bars of 0.2, 0.5, 0.4 and 0.5 m (Grashof: 0.2 + 0.5 ≤ 0.4 + 0.5); the crank is driven.
TEST_P(Physics, FourBarTurnsAsDriven) {
  const Vector3 a{0, 0, 0};
  const Vector3 b{0, 0, 0.2};
  const Vector3 d{0.5, 0, 0};
  // The coupler of 0.5 m from b meets the rocker of 0.4 m from d.
  const Vector3 bd = d - b;
  const double far = length(bd);
  const double along = (far * far + 0.5 * 0.5 - 0.4 * 0.4) / (2 * far);
  const double up = std::sqrt(0.25 - along * along);
  const Vector3 unit = (1 / far) * bd;
  const Vector3 c = b + along * unit + up * Vector3{-unit.z, 0, unit.x};
  Scene scene = hand::scene();
  const auto bar = [&scene](const Vector3& from, const Vector3& to) {
    return add_body(scene, hand::box_mass(1, {0.05, 0.05, length(to - from)}), 0.5 * (from + to));
  };
  const auto crank = bar(a, b);
  const auto coupler = bar(b, c);
  const auto rocker = bar(d, c);
  const Vector3 y{0, 1, 0};
  const auto motor = add_joint(scene, JointType::kRevolute, kWorld, crank, a, {y});
  add_joint(scene, JointType::kRevolute, crank, coupler, b, {y});
  add_joint(scene, JointType::kRevolute, kWorld, rocker, d, {y});
  add_joint(scene, JointType::kRevolute, coupler, rocker, c, {y});
  const auto engine_made = make_engine(scene, settings());
  Engine& engine = *engine_made;
  double worst = 0;
  double aside = 0;
  for (int i = 0; i < 7000; ++i) {
    engine.set_motor(motor, 0, std::min(2.0, 2.0 * i / 500), 1000);
    engine.step();
    worst = std::max(worst, engine.state().anchor_error);
    aside = std::max(aside, std::abs(engine.state().bodies[coupler].p_WBcm.y));
  }
  EXPECT_LT(worst, 2e-4);
  EXPECT_LT(aside, 1e-5);
  EXPECT_NEAR(engine.state().axes[motor].velocity, 2, 2e-3);
  EXPECT_NEAR(engine.state().axes[motor].position, 2 * 7 - 0.5, 1e-2);  // more than two turns
}

// A wheel of 0.02 kg·m² under p = I w², d = 2 z w I: of order two, with w = 10 and z = 0.2.
TEST_P(Physics, PdStepOvershootsAsItShould) {
  Scene scene = hand::scene();
  const double inertia = 0.02;
  const double w = 10;
  const double z = 0.2;
  add_body(scene, {1, {}, {.ixx = inertia, .iyy = inertia, .izz = inertia}}, {});
  add_joint(scene, JointType::kRevolute, kWorld, 0, {}, {{0, 0, 1}});
  simulate::Scenario scenario;
  scenario.commands.push_back({.kind = simulate::CommandKind::kPosition,
                               .value = 1,
                               .end = 5,
                               .gains = simulate::Gains{inertia * w * w, 0, 2 * z * w * inertia}});
  const SolverSettings options = settings();
  const auto engine_made = make_engine(scene, options);
  Engine& engine = *engine_made;
  simulate::Commander commander(scene, scenario, options);
  double peak = 0;
  double when = 0;
  while (engine.state().time < 1) {
    commander.tell(engine);
    engine.step();
    if (engine.state().axes[0].position <= peak) continue;
    peak = engine.state().axes[0].position;
    when = engine.state().time;
  }
  const double damped = std::sqrt(1 - z * z);
  EXPECT_NEAR(peak - 1, std::exp(-kPi * z / damped), 0.01);
  EXPECT_NEAR(when / (kPi / (w * damped)), 1, 0.01);
}

}  // namespace
}  // namespace rigor
