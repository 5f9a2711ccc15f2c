// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/metric/measure.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rigor {
namespace {

using namespace simulate;

constexpr double kStep = 0.001;

/// A body of 2 kg with moments 1, 2, 3 that a hinge about z with limits ±1 connects to the world,
/// a second one of the same model, and the ground.
Scene watched_scene() {
  Scene scene;
  scene.gravity = {0, 0, -10};
  scene.size = 2;
  scene.models.push_back({.name = "m", .base = 0});
  SceneBody body;
  body.mass = {2, {}, {1, 0, 0, 2, 0, 3}};
  scene.bodies = {body, body};
  SceneJoint joint;
  SceneAxis axis;
  axis.lower = -1;
  axis.upper = 1;
  axis.effort = 4;
  joint.axes.push_back(axis);
  joint.child = 0;
  scene.joints.push_back(joint);
  SceneShape shape;
  shape.body = 0;
  scene.shapes.push_back(shape);
  shape.body = 1;
  scene.shapes.push_back(shape);
  shape.body = kWorld;
  scene.shapes.push_back(shape);
  return scene;
}

/// The same without the hinge: what hangs on one may lean and swing.
Scene standing_scene() {
  Scene scene = watched_scene();
  scene.joints.clear();
  return scene;
}

State still(double time) {
  State state;
  state.time = time;
  state.bodies.resize(2);
  state.axes.resize(1);
  return state;
}

Scenario of_phases(std::vector<Phase> phases) {
  Scenario scenario{.name = "t", .duration = phases.back().end};
  scenario.phases = std::move(phases);
  return scenario;
}

TEST(Measure, PhasesShareTheStepsBetweenThemAndMayOverlap) {
  const Scene scene = watched_scene();
  const Scenario scenario = of_phases({{"a", 0, 0.1}, {"b", 0.08, 0.1}, {"c", 0.1, 0.2}});
  Watch watch(scene, scenario, {.step = kStep});
  double time = 0;
  watch.see(still(0));
  for (int i = 0; i < 200; ++i) watch.see(still(time += kStep));  // sums up rounding on purpose
  EXPECT_EQ(watch.measures().phases[0].steps, 100U);
  EXPECT_EQ(watch.measures().phases[1].steps, 20U);
  EXPECT_EQ(watch.measures().phases[2].steps, 100U);
}

TEST(Measure, BeginAndEndAreTheStatesAtTheBounds) {
  const Scene scene = watched_scene();
  const Scenario scenario = of_phases({{"a", 0, 0.01}, {"b", 0.01, 0.02}});
  Watch watch(scene, scenario, {.step = kStep});
  for (int i = 0; i <= 20; ++i) {
    State state = still(i * kStep);
    state.bodies[0].p_WBcm.x = i;
    state.axes[0].position = 0.01 * i;
    state.axes[0].velocity = 10;
    watch.see(state);
  }
  const PhaseMeasures& a = watch.measures().phases[0];
  const PhaseMeasures& b = watch.measures().phases[1];
  EXPECT_EQ(a.begin[0].p_WBcm.x, 0);
  EXPECT_EQ(a.end[0].p_WBcm.x, 10);
  EXPECT_EQ(b.begin[0].p_WBcm.x, 10);
  EXPECT_EQ(b.end[0].p_WBcm.x, 20);
  EXPECT_DOUBLE_EQ(b.axis_begin[0], 0.10);
  EXPECT_DOUBLE_EQ(b.axis_end[0], 0.20);
  EXPECT_NEAR(b.axis_path[0], 10 * 10 * kStep, 1e-12);
}

TEST(Measure, EnergyOfABodyThatIsThrown) {
  const Scene scene = watched_scene();
  const Scenario scenario = of_phases({{"a", 0, 1}});
  Watch watch(scene, scenario, {.step = kStep});
  watch.see(still(0));
  State state = still(kStep);
  state.bodies[0].p_WBcm = {0, 0, 1};  // 2 kg · 10 m/s² · 1 m
  state.bodies[0].v_WBcm = {3, 0, 0};  // 2 kg · 9 / 2
  state.bodies[0].w_WB = {0, 0, 2};    // 3 · 4 / 2
  state.motor_work = 5;
  watch.see(state);
  EXPECT_NEAR(watch.measures().phases[0].energy.value, 20 + 9 + 6 - 5, 1e-12);
}

TEST(Measure, SpinIsTakenAlongTheBodysOwnAxes) {
  const Scene scene = standing_scene();
  const Scenario scenario = of_phases({{"a", 0, 1}});
  Watch watch(scene, scenario, {.step = kStep});
  watch.see(still(0));
  State state = still(kStep);
  // A quarter turn about y takes the body's x, of moment 1, to W's -z.
  state.bodies[0].R_WB = model::from_axis_angle({0, 1, 0}, std::numbers::pi / 2);
  state.bodies[0].w_WB = {0, 0, 2};
  watch.see(state);
  EXPECT_NEAR(watch.measures().phases[0].energy.value, 1 * 4 / 2.0, 1e-12);
  EXPECT_NEAR(watch.measures().phases[0].tilt.value, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(watch.measures().phases[0].tipped, kStep, 1e-12);
}

TEST(Measure, AMotorsWorkAndAPushAreNoGain) {
  const Scene scene = watched_scene();
  Scenario scenario = of_phases({{"a", 0, 1}});
  scenario.pushes.push_back({.body = 0, .impulse_W = {8, 0, 0}, .at = 0.010});
  Watch watch(scene, scenario, {.step = kStep});
  for (int i = 0; i <= 50; ++i) {
    State state = still(i * kStep);
    if (i >= 10) state.bodies[0].v_WBcm = {4, 0, 0};
    if (i >= 30) state.bodies[1].v_WBcm = {1, 0, 0};  // 1 J from nowhere
    watch.see(state);
  }
  EXPECT_NEAR(watch.measures().phases[0].energy.value, 1, 1e-12);
  EXPECT_NEAR(watch.measures().phases[0].energy.at, 0.030, 1e-12);
}

TEST(Measure, SettlesWhenAllHasBeenSlowForAQuarterSecond) {
  const Scene scene = standing_scene();
  const Scenario scenario = of_phases({{"a", 0, 1}});
  Watch watch(scene, scenario, {.step = kStep});
  for (int i = 0; i <= 1000; ++i) {
    State state = still(i * kStep);
    // Fast until 0.3 s, slow for 0.1 s, a shake at 0.4 s by the turn rate alone, then still.
    if (i <= 300) state.bodies[1].v_WBcm = {0, 0.006, 0};
    if (i == 400) state.bodies[0].w_WB = {0.06, 0, 0};
    watch.see(state);
  }
  EXPECT_NEAR(watch.measures().settle_time, 0.400, 1e-9);
}

TEST(Measure, NeverSettledIsInfinite) {
  const Scene scene = watched_scene();
  const Scenario scenario = of_phases({{"a", 0, 0.2}});
  Watch watch(scene, scenario, {.step = kStep});
  for (int i = 0; i <= 200; ++i) watch.see(still(i * kStep));  // slow, but not for long enough
  EXPECT_EQ(watch.measures().settle_time, kInfinity);
}

TEST(Measure, LimitsEffortAndJitterOfAnAxis) {
  const Scene scene = watched_scene();
  const Scenario scenario = of_phases({{"a", 0, 0.5}, {"b", 0.5, 1}});
  Watch watch(scene, scenario, {.step = kStep});
  for (int i = 0; i <= 1000; ++i) {
    const double t = i * kStep;
    State state = still(t);
    state.axes[0].position = 1.2 * std::sin(2 * t);
    state.axes[0].effort = -3;
    // First a steady rise of 10 rad/s²; then 0.1 rad/s at 200 Hz, ten times the filter's corner.
    state.axes[0].velocity = i <= 500 ? 10 * t : 5 + 0.1 * std::sin(2 * std::numbers::pi * 200 * t);
    watch.see(state);
  }
  const PhaseMeasures& a = watch.measures().phases[0];
  const PhaseMeasures& b = watch.measures().phases[1];
  EXPECT_NEAR(b.limit_violation.value, 0.2, 1e-4);  // the crest, at π/4 s
  EXPECT_NEAR(b.axis_effort[0], 0.75, 1e-9);
  const double ramp = std::sqrt(a.jitter_square[0] / static_cast<double>(a.steps));
  const double chatter = std::sqrt(b.jitter_square[0] / static_cast<double>(b.steps));
  EXPECT_LT(ramp, 0.03);  // the second order of the filter forgets a ramp but for its first 50 ms
  EXPECT_NEAR(chatter, 0.1 / std::sqrt(2), 0.012);  // as a sine's, less the filter's few per cent
}

TEST(Measure, ContactsAreWithTheGroundOrAmongThemselves) {
  const Scene scene = watched_scene();
  const Scenario scenario = of_phases({{"a", 0, 0.01}});
  Watch watch(scene, scenario, {.step = kStep});
  State state = still(0);
  state.contacts.push_back({.shape_a = 2, .shape_b = 1, .depth = 0.03});
  state.contacts.push_back({.shape_a = 0, .shape_b = 1, .depth = 0.02});
  watch.see(state);
  for (int i = 1; i <= 10; ++i) {
    state = still(i * kStep);
    // The ground is `a` of one contact and `b` of the other: forces are those on `a`.
    state.contacts.push_back({.shape_a = 2, .shape_b = 1, .depth = 0.01 / i, .force = {0, 0, -7}});
    if (i % 2 == 0) {
      state.contacts.push_back(
          {.shape_a = 0, .shape_b = 2, .point = {1, 2, 0}, .depth = 0.001, .force = {0, 0, 3}});
    }
    state.contacts.push_back({.shape_a = 0, .shape_b = 1, .depth = 0.004});
    watch.see(state);
  }
  const Measures& all = watch.measures();
  EXPECT_EQ(all.spawn_penetration.value, 0.03);
  EXPECT_EQ(all.spawn_penetration.of, 1U);
  EXPECT_EQ(all.spawn_overlap.value, 0.02);
  EXPECT_EQ(all.spawn_overlap.of, 0U);
  EXPECT_EQ(all.spawn_overlap_with, 1U);
  const PhaseMeasures& a = all.phases[0];
  EXPECT_EQ(a.penetration.value, 0.01);
  EXPECT_EQ(a.penetration.of, 1U);
  EXPECT_EQ(a.sunk.value, 0.001);
  EXPECT_EQ(a.self_contact.value, 0.004);
  EXPECT_EQ(a.self_contact_with, 1U);
  EXPECT_NEAR(a.ground_force.z, 10 * 7 + 5 * 3, 1e-12);
  EXPECT_EQ(a.contact_changes, 9U);
  EXPECT_EQ(all.support.size(), 15U);
}

TEST(Measure, AnImpactIsNoChatter) {
  const Scene scene = watched_scene();
  const Scenario scenario = of_phases({{"a", 0, 1}});
  Watch watch(scene, scenario, {.step = kStep});
  State state = still(0);
  state.bodies[0].v_WBcm = {0, 0, -1};
  watch.see(state);
  state.time = kStep;
  state.bodies[0].v_WBcm = {0, 0, 0};
  state.contacts.push_back({.shape_a = 0, .shape_b = 2});
  watch.see(state);
  EXPECT_EQ(watch.measures().phases[0].acceleration.value, 0);
  state.time = 2 * kStep;
  state.bodies[0].v_WBcm = {0, 0, 0.5};
  watch.see(state);
  EXPECT_NEAR(watch.measures().phases[0].acceleration.value, 0.5 / kStep, 1e-9);
  EXPECT_EQ(watch.measures().phases[0].speed.value, 0.5);
}

TEST(Measure, TurnsOfTheBaseAreCountedBeyondAFullOne) {
  const Scene scene = watched_scene();
  const Scenario scenario = of_phases({{"a", 0, 2}});
  Watch watch(scene, scenario, {.step = kStep});
  for (int i = 0; i <= 2000; ++i) {
    State state = still(i * kStep);
    state.bodies[0].w_WB = {0, 0, 5};
    state.bodies[0].v_WBcm = {0, 0, 0.1};
    watch.see(state);
  }
  EXPECT_NEAR(watch.measures().phases[0].yaw_path[0], 10, 1e-9);
  EXPECT_NEAR(watch.measures().phases[0].vertical_square[0], 2000 * 0.01, 1e-9);
}

}  // namespace
}  // namespace rigor
