// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What keeps models up, and what worlds that are meant to move are judged by.

#include <rigor/simulate/footing.h>

#include <gtest/gtest.h>

#include <cmath>

#include <rigor/simulate/simulate.h>
#include <rigor/simulate/test/tests.h>

#include "simulate/built.h"
#include "support/workers.h"

namespace rigor {
namespace {

using namespace simulate;
using Kind = Footing::Kind;
using test::built;
using test::Built;

std::string world_of(const std::string& models, const std::string& gravity = "0 0 -9.8") {
  return "<sdf version=\"1.9\"><world name=\"w\"><gravity>" + gravity + "</gravity>" + models +
         "</world></sdf>";
}

const std::string kPlane =
    "<model name=\"ground\"><static>true</static><link name=\"l\"><collision name=\"c\"><geometry>"
    "<plane/></geometry></collision></link></model>";

/// A cube of 1 m and 1 kg with its middle at a place.
std::string crate(const std::string& name, const std::string& at, bool is_static = false) {
  return "<model name=\"" + name + "\"><static>" + (is_static ? "true" : "false") +
         "</static><pose>" + at +
         " 0 0 0</pose><link name=\"l\"><inertial><mass>1</mass><inertia><ixx>0.1667</ixx>"
         "<iyy>0.1667</iyy><izz>0.1667</izz></inertia></inertial><collision name=\"c\"><geometry>"
         "<box><size>1 1 1</size></box></geometry></collision></link></model>";
}

/// A rod of 1 m that hangs level from a pivot at its end, 3 m up.
std::string pendulum(const std::string& joint) {
  return "<model name=\"pendulum\"><link name=\"rod\"><pose>0.5 0 3 0 0 0</pose><inertial><mass>1"
         "</mass><inertia><ixx>0.0003</ixx><iyy>0.0835</iyy><izz>0.0835</izz></inertia></inertial>"
         "<collision name=\"c\"><geometry><box><size>1 0.04 "
         "0.04</size></box></geometry></collision>"
         "</link><joint name=\"pivot\" type=\"" +
         joint +
         "\"><pose>-0.5 0 0 0 0 0</pose><parent>world</parent><child>rod</child><axis><xyz>0 1 0"
         "</xyz></axis></joint></model>";
}

std::vector<Footing> footings(const std::string& models) {
  return footings_of(built(world_of(models)).scene);
}

TEST(Footing, OnThePlaneOnACrateAndBesideIt) {
  const auto found = footings(crate("board", "0 0 0.5", true) + crate("on", "0.9 0 1.5") +
                              crate("higher", "0.9 0.5 2.5") + crate("beside", "1.2 2 1.5"));
  EXPECT_EQ(found[1].kind, Kind::kStands);
  EXPECT_EQ(found[2].kind, Kind::kStands);  // on what stands
  EXPECT_EQ(found[3].kind, Kind::kInTheAir);
  EXPECT_TRUE(std::isinf(found[3].gap));
}

/// In 0.4 s a stone falls 9.8 · 0.4² / 2 = 0.784 m.
TEST(Footing, AShortFallIsNone) {
  const auto found = footings(kPlane + crate("low", "0 0 1.27") + crate("high", "5 0 1.30") +
                              crate("above", "5 0 2.5"));
  EXPECT_EQ(found[1].kind, Kind::kStands);
  EXPECT_EQ(found[2].kind, Kind::kInTheAir);
  EXPECT_NEAR(found[2].gap, 0.8, 1e-9);
  EXPECT_EQ(found[3].kind, Kind::kInTheAir);
  EXPECT_NEAR(found[3].gap, 2, 1e-9);  // what falls holds nothing
}

/// A valley along y between walls of 4 m, whose floor, 2 m wide, is at 1 m.
TEST(Footing, OverLandTheHeightIsThatBelow) {
  Built b = built(world_of(crate("low", "0 0 1.6") + crate("high", "0 3 3") +
                           crate("wall", "2.5 0 4.7") + crate("beside", "9 0 1")));
  HeightGrid grid{.columns = 5, .rows = 2, .width = 8, .depth = 8, .heights = {}};
  for (int row = 0; row < 2; ++row) grid.heights.insert(grid.heights.end(), {4, 1, 1, 1, 4});
  grid.heights[2] = 0;  // a hole on one side changes nothing
  b.scene.shapes.push_back({.name = "land", .kind = grid, .extent = 8});
  const auto found = footings_of(b.scene);
  EXPECT_EQ(found[0].kind, Kind::kStands);
  EXPECT_NEAR(found[1].gap, 1.5, 1e-12);
  EXPECT_EQ(found[2].kind, Kind::kStands);  // its cell reaches up to the wall's top
  EXPECT_TRUE(std::isinf(found[3].gap));
}

TEST(Footing, DownIsWhereGravityPulls) {
  const std::string text = world_of(crate("wall", "3 0 0", true) + crate("a", "2 0 0"), "9 0 0");
  EXPECT_EQ(footings_of(built(text).scene)[1].kind, Kind::kStands);
  const std::string away = test::replaced(text, "9 0 0", "-9 0 0");
  EXPECT_EQ(footings_of(built(away).scene)[1].kind, Kind::kInTheAir);
}

TEST(Footing, WhatAJointHoldsHangs) {
  const Built b = built(world_of(pendulum("ball")));
  EXPECT_EQ(footings_of(b.scene)[0].kind, Kind::kHangs);
  Scenario scenario{.name = "s"};
  EXPECT_TRUE(moving_freely(b.scene, scenario)[0]);
  scenario.commands.push_back({.joint = 0, .kind = CommandKind::kVelocity});
  EXPECT_FALSE(moving_freely(b.scene, scenario)[0]);  // held by a motor
}

TEST(Footing, AMotorWithoutEffortHoldsNothing) {
  Built b = built(world_of(pendulum("revolute")));
  const Scenario scenario{.name = "s", .commands = {{.kind = CommandKind::kVelocity}}};
  EXPECT_FALSE(moving_freely(b.scene, scenario)[0]);
  b.scene.joints[0].axes[0].effort = 0;
  EXPECT_TRUE(moving_freely(b.scene, scenario)[0]);
}

simulate::Run tried(std::string_view test, const std::string& text) {
  const Built b = built(text);
  EXPECT_FALSE(b.blocked);
  const DriveTrain wheels;
  const Facts causes;
  const Task task{
      b.scene, causes, {*make_test(test, b.scene, wheels).scenario}, wheels, b.scene.solver};
  return std::move(simulate::simulate({task}, {.jobs = 2}, test::workers())[0].runs[0]);
}

simulate::Run settled(const std::string& text) { return tried("settle", text); }

const Metric* metric_of(const simulate::Run& run, std::string_view id) {
  const auto found = std::find_if(run.metrics.begin(), run.metrics.end(),
                                  [id](const Metric& metric) { return metric.id == id; });
  return found == run.metrics.end() ? nullptr : &*found;
}

/// It swings through, faster than 3 m/s, and no energy comes from anywhere.
TEST(MovingWorld, APendulumMaySwing) {
  const simulate::Run run = settled(world_of(kPlane + pendulum("ball")));
  EXPECT_NE(run.verdict, Verdict::kFail);
  EXPECT_EQ(metric_of(run, "tilt.max")->value, 0);
  EXPECT_EQ(metric_of(run, "rest.residual_v")->value, 0);
  EXPECT_LT(metric_of(run, "energy.gain")->value, 0.01);
  const model::Vector3 moved = run.record.final.bodies[0].p_WBcm - model::Vector3{0.5, 0, 3};
  EXPECT_GT(length(moved), 0.2);
}

TEST(MovingWorld, WhatHasNothingBelowItIsAWarning) {
  const simulate::Run run =
      settled(world_of(crate("board", "0 0 0", true) + crate("a", "0 0 1") + crate("b", "4 0 1")));
  EXPECT_EQ(run.verdict, Verdict::kWarn);
  ASSERT_TRUE(metric_of(run, "spawn.gap"));
  EXPECT_TRUE(std::isinf(metric_of(run, "spawn.gap")->value));
  EXPECT_EQ(metric_of(run, "spawn.gap")->fact->subject, "b");
  EXPECT_LT(metric_of(run, "rest.residual_v")->value, 0.005);  // that of the other
}

TEST(MovingWorld, WhatFallsFromFarAboveIsAWarning) {
  const simulate::Run run = settled(world_of(kPlane + crate("a", "0 0 8")));
  EXPECT_EQ(run.verdict, Verdict::kWarn);
  EXPECT_NEAR(metric_of(run, "spawn.gap")->value, 7.5, 1e-9);
}

const std::string kBall =
    "<model name=\"ball\"><pose>0 0 0.5 0 0 0</pose><link name=\"l\"><inertial><mass>1</mass>"
    "<inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial><collision name=\"c\">"
    "<geometry><sphere><radius>0.5</radius></sphere></geometry></collision></link></model>";

/// Gravity leans by 0.1 rad: a ball of 0.1 kg·m² rolls with g sin / (1 + I/(m r²)) = 0.7 m/s².
TEST(MovingWorld, ABallMayRoll) {
  const simulate::Run run = settled(world_of(kPlane + kBall, "0.98 0 -9.75"));
  EXPECT_EQ(run.verdict, Verdict::kWarn);
  EXPECT_NEAR(run.record.final.bodies[0].v_WBcm.x, 0.7, 0.02);
  EXPECT_EQ(metric_of(run, "rest.creep")->verdict, Verdict::kWarn);
  const simulate::Run dropped = tried("drop", world_of(kPlane + kBall, "0.98 0 -9.75"));
  EXPECT_EQ(dropped.verdict, Verdict::kWarn);
  EXPECT_GT(dropped.record.final.bodies[0].v_WBcm.x, 0.7);
}

/// About a level axis only: however far it has rolled, it has turned over no ground. On 0.3 rad it rolls
/// 2.7 times round in the last fifth.
TEST(MovingWorld, ABallThatRollsDoesNotTurnOverTheGround) {
  const std::string small = test::replaced(test::replaced(kBall, "<radius>0.5", "<radius>0.02"),
                                           "<pose>0 0 0.5", "<pose>0 0 0.02");
  const simulate::Run run =
      settled(world_of(kPlane + test::replaced(small, "<ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1",
                                               "<ixx>0.0002</ixx><iyy>0.0002</iyy><izz>0.0002"),
                       "2.9 0 -9.37"));
  EXPECT_GT(run.record.final.bodies[0].w_WB.y, 50);
  EXPECT_LT(metric_of(run, "rest.yaw_creep")->value, 0.1);
}

/// A blow makes it swing: that is no lean.
TEST(MovingWorld, WhatHangsIsNotPushedOver) {
  const simulate::Run run = tried("push", world_of(kPlane + pendulum("revolute")));
  EXPECT_NE(run.verdict, Verdict::kFail);
  EXPECT_EQ(metric_of(run, "push.tilt"), nullptr);
}

/// But a robot that tips over, or begins in the ground, is no better in a world.
TEST(MovingWorld, WhatIsWrongIsStillAFailure) {
  const simulate::Run sunk = settled(world_of(kPlane + crate("a", "0 0 0.4")));
  EXPECT_EQ(sunk.verdict, Verdict::kFail);
  const simulate::Run edge =
      settled(world_of(crate("board", "0 0 0", true) + crate("a", "0.8 0 1") + kPlane));
  EXPECT_EQ(edge.verdict, Verdict::kFail);
}

}  // namespace
}  // namespace rigor
