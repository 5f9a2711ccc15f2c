// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/run.h>

#include <cmath>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>
#include <rigor/simulate/reach.h>
#include <rigor/simulate/stage.h>

#include "simulate/hand_scene.h"
#include "support/workers.h"

namespace rigor {
namespace {

using hand::add_body;
using hand::add_ground;
using hand::add_joint;
using hand::add_shape;
using hand::Scene;
using model::JointType;
using simulate::Command;
using simulate::CommandKind;
using simulate::kWorld;
using simulate::Record;
using simulate::Scenario;

/// Six boxes that fall on each other: chaotic enough that each last bit shows.
Scene boxes_that_tumble() {
  Scene scene = hand::scene();
  for (std::uint32_t i = 0; i < 6; ++i) {
    if (i > 0) scene.models.push_back({.name = "box" + std::to_string(i), .base = i});
    const auto body =
        add_body(scene, hand::box_mass(1, {0.2, 0.2, 0.2}), {0.03 * i, 0.02 * i, 0.2 + 0.3 * i},
                 model::from_rpy(0.3 * i, 0.2, 0));
    scene.bodies[body].model = i;
    add_shape(scene, body, mesh::Box{{0.2, 0.2, 0.2}});
  }
  add_ground(scene);
  return scene;
}

Scenario lasting(double seconds) {
  return {.name = "test", .duration = seconds, .phases = {{"all", 0, seconds}}};
}

TEST(Run, RepeatsToTheLastBit) {
  const Scene scene = boxes_that_tumble();
  simulate::SolverSettings settings;
  const Record first = run(scene, lasting(1), settings);
  const Record again = run(scene, lasting(1), settings);
  const Record apart = run_isolated(scene, lasting(1), settings, test::workers());
  EXPECT_EQ(first.end, Record::End::kDone);
  EXPECT_EQ(first.state_hash.size(), 32U);
  EXPECT_EQ(again.state_hash, first.state_hash);
  EXPECT_EQ(apart.state_hash, first.state_hash);
  EXPECT_EQ(encode(apart), encode(first));
  settings.seed = 1;
  EXPECT_NE(run(scene, lasting(1), settings).state_hash, first.state_hash);
}

TEST(Run, KeepsARowEachHundredthOfASecond) {
  const Scene scene = boxes_that_tumble();
  const Record record = run(scene, lasting(0.5), {});
  EXPECT_EQ(record.steps, 500U);
  EXPECT_NEAR(record.end_time, 0.5, 1e-12);
  ASSERT_EQ(record.times.size(), 51U);
  EXPECT_NEAR(record.times[7], 0.07, 1e-12);
  EXPECT_EQ(record.link_poses.size(), 51U * 6);
  EXPECT_EQ(record.link_poses.front(), scene.bodies[0].X_WB);
  EXPECT_EQ(record.measures.phases.size(), 1U);
  EXPECT_EQ(record.final.bodies.size(), 6U);
}

TEST(Run, RecordsComeBackExactly) {
  Scene scene = boxes_that_tumble();
  add_joint(scene, JointType::kRevolute, kWorld, 5, {0.15, 0.1, 1.7}, {{0, 0, 1}});
  Record record = run(scene, lasting(0.1), {});
  record.message = "a word";
  record.measures.settle_time = std::nan("");
  const std::string bytes = encode(record);
  const auto back = simulate::decode(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(encode(*back), bytes);
  EXPECT_EQ(back->message, "a word");
  EXPECT_EQ(back->times, record.times);
  EXPECT_EQ(back->axis_values, record.axis_values);
  EXPECT_EQ(back->final.contacts.size(), record.final.contacts.size());
}

TEST(Run, DamagedRecordsAreRefused) {
  const Scene scene = boxes_that_tumble();
  const std::string bytes = encode(run(scene, lasting(0.02), {}));
  EXPECT_FALSE(simulate::decode(""));
  for (std::size_t size = 0; size < bytes.size(); size += 97) {
    EXPECT_FALSE(simulate::decode(std::string_view(bytes).substr(0, size)));
  }
  EXPECT_FALSE(simulate::decode(bytes + "x"));
  for (std::size_t at = 0; at < bytes.size(); at += 31) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    EXPECT_FALSE(simulate::decode(damaged)) << at;
  }
  const process::RequestResult handed{.end = process::RequestResult::End::kDone,
                                      .bytes = "nonsense"};
  EXPECT_EQ(simulate::record_of(handed).end, Record::End::kCrashed);
  EXPECT_FALSE(simulate::record_of(handed).message.empty());
}

TEST(Run, WhatTheEngineRefusesIsAnEnd) {
  Scene scene = boxes_that_tumble();
  scene.bodies[2].mass.about_com.ixx = -1;
  const Record record = run_isolated(scene, lasting(1), {}, test::workers());
  EXPECT_EQ(record.end, Record::End::kRefused);
  EXPECT_FALSE(record.message.empty());
  Scenario nobody = lasting(1);
  nobody.commands.push_back({.joint = 7});
  EXPECT_EQ(run_isolated(boxes_that_tumble(), nobody, {}, test::workers()).end,
            Record::End::kRefused);
}

TEST(Run, EndsWhenSomethingIsFarAway) {
  Scene scene = hand::scene();
  scene.size = 0.2;
  add_body(scene, hand::ball_mass(1, 0.1), {});
  add_body(scene, hand::ball_mass(1, 0.1), {1, 0, 0});
  scene.bodies[0].gravity = false;
  const Record record = run(scene, lasting(100), {});
  EXPECT_EQ(record.end, Record::End::kFarAway);
  EXPECT_EQ(record.culprit, 1U);
  EXPECT_NEAR(record.end_time, std::sqrt(2 * 200 / 9.8), 0.01);
}

TEST(Run, EndsWhenSomethingIsNoNumber) {
  Scene scene = hand::scene();
  add_body(scene, hand::ball_mass(1, 0.1), {});
  Scenario scenario = lasting(1);
  scenario.pushes.push_back(
      {.body = 0, .impulse_W = {1e308, 1e308, 1e308}, .p_BP = {1, 0, 0}, .at = 0.1});
  const Record record = run_isolated(scene, scenario, {}, test::workers());
  EXPECT_EQ(record.end, Record::End::kNotFinite);
  EXPECT_EQ(record.culprit, 0U);
  EXPECT_NEAR(record.end_time, 0.1, 0.01);
}

TEST(Run, StepsAreBounded) {
  const Scene scene = boxes_that_tumble();
  EXPECT_EQ(run(scene, lasting(1e7), {}).end, Record::End::kOutOfTime);
  EXPECT_EQ(run(scene, lasting(std::nan("")), {}).end, Record::End::kOutOfTime);
  simulate::SolverSettings still;
  still.step = 0;
  EXPECT_EQ(run(scene, lasting(1), still).end, Record::End::kOutOfTime);
}

/// A wheel of 0.02 kg·m² on a hinge, in no gravity.
Scene wheel_on_a_hinge() {
  Scene scene = hand::scene();
  scene.gravity = {};
  add_body(scene, {1, {}, {.ixx = 0.02, .iyy = 0.02, .izz = 0.02}}, {});
  add_joint(scene, JointType::kRevolute, kWorld, 0, {}, {{0, 0, 1}});
  return scene;
}

simulate::AxisState after(const Scene& scene, double seconds,
                          const std::vector<Command>& commands) {
  Scenario scenario = lasting(seconds);
  scenario.commands = commands;
  return run(scene, scenario, hand::stiff()).final.axes[0];
}

TEST(Run, VelocitiesRampUpAndEnd) {
  const Scene scene = wheel_on_a_hinge();
  const Command spin{.value = 4, .begin = 0.5, .end = 2, .ramp = 1};
  EXPECT_NEAR(after(scene, 0.5, {spin}).velocity, 0, 1e-9);
  EXPECT_NEAR(after(scene, 1, {spin}).velocity, 2, 5e-3);
  EXPECT_NEAR(after(scene, 2, {spin}).velocity, 4, 1e-6);
  // A ramp, then half a second: 4/2 + 4/2.
  EXPECT_NEAR(after(scene, 2, {spin}).position, 4, 1e-2);
  EXPECT_NEAR(after(scene, 2.5, {spin}).effort, 0, 1e-12);
  // The next one goes on from there.
  const Command slower{.value = 2, .begin = 2, .end = 3, .ramp = 1};
  EXPECT_NEAR(after(scene, 2.5, {spin, slower}).velocity, 3, 5e-3);
}

TEST(Run, VelocityCommandsKeepTheJointsLimit) {
  Scene scene = wheel_on_a_hinge();
  scene.joints[0].axes[0].velocity = 1.5;
  EXPECT_NEAR(after(scene, 0.5, {{.value = -4, .end = 1}}).velocity, -1.5, 1e-6);
}

TEST(Run, EffortsAreCutByCommandAndJoint) {
  Scene scene = wheel_on_a_hinge();
  const Command effort{.kind = CommandKind::kEffort, .value = 3, .end = 1, .effort = 0.5};
  EXPECT_NEAR(after(scene, 0.1, {effort}).velocity, 0.1 * 0.5 / 0.02, 1e-9);
  scene.joints[0].axes[0].effort = 0.2;
  EXPECT_NEAR(after(scene, 0.1, {effort}).velocity, 0.1 * 0.2 / 0.02, 1e-9);
}

TEST(Run, PositionsAreReached) {
  Scene scene = wheel_on_a_hinge();
  const Command go{.kind = CommandKind::kPosition, .value = -1.2, .end = 2, .ramp = 0.5};
  EXPECT_NEAR(after(scene, 1, {go}).position, -1.2, 1e-4);
  EXPECT_NEAR(after(scene, 0.25, {go}).position, -0.6, 5e-3);
  // Over more than a turn, and no faster than the joint may.
  scene.joints[0].axes[0].velocity = 5;
  const Command far{.kind = CommandKind::kPosition, .value = 10, .end = 4};
  EXPECT_NEAR(after(scene, 1, {far}).position, 5, 1e-2);
  EXPECT_NEAR(after(scene, 3, {far}).position, 10, 1e-3);
  // A critically damped controller against a constant load: the integral takes it away.
  Scene loaded = wheel_on_a_hinge();
  loaded.joints[0].axes[0].spring_stiffness = 0.5;
  const Command pid{.kind = CommandKind::kPosition, .value = 1, .end = 9, .gains = {{2, 4, 0.4}}};
  EXPECT_NEAR(after(loaded, 8, {pid}).position, 1, 1e-3);
  const Command pd{.kind = CommandKind::kPosition, .value = 1, .end = 9, .gains = {{2, 0, 0.4}}};
  EXPECT_NEAR(after(loaded, 8, {pd}).position, 2 / 2.5, 1e-3);
}

TEST(Run, PushesOnce) {
  Scene scene = hand::scene();
  scene.gravity = {};
  mass::MassProperties body = hand::ball_mass(2, 0.1);
  body.com = {0, 0, 0.3};
  add_body(scene, body, {});
  Scenario scenario = lasting(1);
  scenario.pushes.push_back({.body = 0, .impulse_W = {3, 0, 0}, .p_BP = {0, 0, 0.3}, .at = 0.2});
  const Record record = run(scene, scenario, hand::stiff());
  EXPECT_NEAR(record.final.bodies[0].v_WBcm.x, 1.5, 1e-9);
  EXPECT_NEAR(record.final.bodies[0].w_WB.y, 0, 1e-9);
  EXPECT_NEAR(record.final.bodies[0].p_WBcm.x, 1.2, 2e-3);
}

// A table that turns about y sends what lies on it towards +x, once it is steeper than its friction.
TEST(Run, TablesTilt) {
  Scene scene = hand::scene();
  add_body(scene, hand::box_mass(1, {0.4, 0.4, 0.1}), {0, 0, 0.05});
  auto& surface = add_shape(scene, 0, mesh::Box{{0.4, 0.4, 0.1}}).surface;
  surface.mu = 0.3;
  surface.mu2 = 0.3;
  add_ground(scene);
  Scenario scenario = lasting(2.5);
  const double slides = std::atan(0.3);
  scenario.tilts.push_back({.begin = 0.5, .end = 1.5, .angle = 0.95 * slides});
  EXPECT_NEAR(run(scene, scenario, hand::stiff()).final.bodies[0].p_WBcm.x, 0, 1e-3);
  scenario.tilts[0].angle = 1.2 * slides;
  EXPECT_GT(run(scene, scenario, hand::stiff()).final.bodies[0].p_WBcm.x, 0.1);
}

TEST(Stage, FindsTheLowestPointOfEachShape) {
  const double tilt = 0.4;
  const auto lowest = [&](const simulate::SceneShapeKind& kind) {
    Scene scene = hand::scene();
    scene.meshes.push_back(mesh::mesh_of(mesh::Box{{0.2, 0.4, 0.6}}));
    add_body(scene, hand::ball_mass(1, 0.1), {0, 0, 1}, model::from_rpy(tilt, 0, 0));
    add_shape(scene, 0, kind);
    return 1 - simulate::lowest_of_model(scene, 0);
  };
  const double box = 0.3 * std::cos(tilt) + 0.2 * std::sin(tilt);
  EXPECT_NEAR(lowest(mesh::Box{{0.2, 0.4, 0.6}}), box, 1e-12);
  EXPECT_NEAR(lowest(simulate::ConvexHull{0}), box, 1e-12);
  EXPECT_NEAR(lowest(simulate::TriangleSoup{0}), box, 1e-12);
  EXPECT_NEAR(lowest(mesh::Sphere{0.2}), 0.2, 1e-12);
  EXPECT_NEAR(lowest(mesh::Cylinder{0.2, 0.6}), 0.3 * std::cos(tilt) + 0.2 * std::sin(tilt), 1e-12);
  EXPECT_NEAR(lowest(mesh::Capsule{0.2, 0.6}), 0.3 * std::cos(tilt) + 0.2, 1e-12);
  EXPECT_EQ(simulate::lowest_of_model(hand::scene(), 0), simulate::kInfinity);
}

TEST(Stage, SetsModelsDownWithTheirJoints) {
  Scene scene = hand::scene();
  add_body(scene, hand::ball_mass(1, 0.1), {0, 0, 0.7});
  add_shape(scene, 0, mesh::Sphere{0.2});
  add_body(scene, hand::ball_mass(1, 0.1), {0, 0, 1.7});
  add_joint(scene, JointType::kRevolute, 0, 1, {0, 0, 1.2}, {{0, 1, 0}});
  const Scene down = stage(scene, {.spawn = simulate::Spawn::kOnGround, .drop = 0.05});
  EXPECT_NEAR(down.bodies[0].X_WB.translation.z, 0.25, 1e-12);
  EXPECT_NEAR(down.bodies[1].X_WB.translation.z, 1.25, 1e-12);
  EXPECT_NEAR(down.joints[0].anchor_W.z, 0.75, 1e-12);
  ASSERT_EQ(down.shapes.size(), 2U);
  EXPECT_EQ(down.shapes[1].name, "ground");
  const Scene as_written = stage(scene, {.gravity = false, .ground = false});
  EXPECT_EQ(as_written.bodies[0].X_WB, scene.bodies[0].X_WB);
  EXPECT_EQ(as_written.shapes.size(), 1U);
  EXPECT_EQ(as_written.gravity, hand::Vector3{});
  // What hangs on the world stays there.
  add_joint(scene, JointType::kRevolute, kWorld, 1, {0, 0, 2}, {{0, 1, 0}});
  const Scene hung = stage(scene, {.spawn = simulate::Spawn::kOnGround});
  EXPECT_EQ(hung.bodies[0].X_WB, scene.bodies[0].X_WB);
}

}  // namespace
}  // namespace rigor
