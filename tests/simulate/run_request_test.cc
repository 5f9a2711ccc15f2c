// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/run_request.h>

#include <gtest/gtest.h>

#include <rigor/simulate/run.h>

#include "simulate/hand_robot.h"
#include "simulate/hand_scene.h"
#include "support/workers.h"

namespace rigor::test {
namespace {

using simulate::decode_run;
using simulate::encode_run;
using simulate::RunRequest;
using simulate::Scenario;
using simulate::Scene;

/// Every kind of shape, and a joint with everything that one may have.
Scene scene_of_everything() {
  Scene scene = hand::tutorial_robot();
  scene.meshes.push_back(
      {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}});
  const std::vector<simulate::SceneShapeKind> kinds{
      mesh::Box{{1, 2, 3}},           mesh::Sphere{4},
      mesh::Cylinder{5, 6},           mesh::Capsule{7, 8},
      simulate::ConvexHull{0},        simulate::TriangleSoup{0},
      simulate::HalfSpace{{0, 1, 0}}, simulate::HeightGrid{2, 2, 3, 4, {0, 1, 2, 3}}};
  for (const auto& kind : kinds) scene.shapes.push_back({.name = "shape", .body = 0, .kind = kind});
  simulate::SceneJoint& joint = scene.joints.at(0);
  joint.mimics.push_back({1, 0, 2, 3, 4});
  joint.axes.at(0).limit_where = {SourceId{3}, 14, 15};
  return scene;
}

Scenario scenario_of_everything() {
  Scenario scenario{.name = "all", .duration = 0.5, .phases = {{"begin", 0, 0.5}}};
  scenario.commands.push_back(
      {.joint = 0, .value = 1, .end = 0.5, .gains = simulate::Gains{1, 2, 3}});
  scenario.commands.push_back({.joint = 1, .kind = simulate::CommandKind::kEffort});
  scenario.pushes.push_back({.body = 0, .impulse_W = {1, 2, 3}});
  scenario.tilts.push_back({.begin = 0.1, .end = 0.2, .angle = 0.3});
  scenario.assertions.push_back({.name = "stands", .quantity = "z of base", .least = -1});
  scenario.gravity_W = simulate::Vector3{0, 0, -3.7};
  scenario.solver = simulate::Solver::kDantzig;
  return scenario;
}

TEST(RunRequestBytes, ComeBackAsTheyWere) {
  const Scene scene = scene_of_everything();
  const Scenario scenario = scenario_of_everything();
  const simulate::SolverSettings settings{.step = 0.002, .seed = 5};
  const std::string bytes = encode_run(scene, scenario, settings);
  const std::optional<RunRequest> back = decode_run(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(encode_run(back->scene, back->scenario, back->settings), bytes);
  EXPECT_EQ(back->scene.shapes.back().kind.index(), 7U);
  EXPECT_EQ(std::get<simulate::HeightGrid>(back->scene.shapes.back().kind).heights,
            (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(back->scene.joints[0].axes[0].limit_where.begin, 14U);
  EXPECT_EQ(back->scene.joints[0].mimics[0].multiplier, 2);
  EXPECT_EQ(back->scene.meshes[0].triangles.size(), scene.meshes[0].triangles.size());
  EXPECT_EQ(back->scenario.commands[0].gains->d, 3);
  EXPECT_FALSE(back->scenario.commands[1].gains);
  EXPECT_EQ(back->scenario.gravity_W->z, -3.7);
  EXPECT_FALSE(back->scenario.step);
  EXPECT_EQ(back->settings.seed, 5U);
}

TEST(RunRequestBytes, DamagedOnesAreNone) {
  const std::string bytes = encode_run(scene_of_everything(), scenario_of_everything(), {});
  for (std::size_t size = 0; size < bytes.size(); size += 13) {
    EXPECT_FALSE(decode_run(bytes.substr(0, size))) << size;
  }
  EXPECT_FALSE(decode_run(bytes + "x"));
}

/// ODE is of no use in the process that it refused something in: the next run has a worker of its own.
TEST(RunRequestBytes, AfterARefusalTheNextRunIsSound) {
  Scene refused = hand::scene();
  hand::add_body(refused, hand::ball_mass(1, 0.1), {});
  Scene sound = refused;
  refused.bodies[0].mass.about_com.ixx = -1;
  const Scenario scenario{.name = "fall", .duration = 0.1, .phases = {{"all", 0, 0.1}}};
  const simulate::Record before = run_isolated(sound, scenario, {}, workers());
  EXPECT_EQ(run_isolated(refused, scenario, {}, workers()).end, simulate::Record::End::kRefused);
  EXPECT_EQ(encode(run_isolated(sound, scenario, {}, workers())), encode(before));
  EXPECT_EQ(before.end, simulate::Record::End::kDone);
}

TEST(RunRequestBytes, WithoutAWorkerTheRecordSaysSo) {
  const simulate::Record record =
      run_isolated(hand::scene(), {}, {}, process::Workers("/nowhere/rigor-worker"));
  EXPECT_EQ(record.end, simulate::Record::End::kCrashed);
  EXPECT_EQ(record.message,
            "could not be started: /nowhere/rigor-worker: No such file or directory");
}

}  // namespace
}  // namespace rigor::test
