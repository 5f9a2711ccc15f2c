// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Heightmaps as ground. Pictures are seen from above, with y upward on them.

#include <gtest/gtest.h>

#include <cmath>

#include <rigor/simulate/engine/ode/ode_engine.h>

#include "simulate/built.h"
#include "simulate/hand_scene.h"
#include "support/height_png.h"

namespace rigor {
namespace {

using simulate::FactKind;
using simulate::HeightGrid;
using test::built;
using test::Built;
using Levels = std::vector<std::uint8_t>;

std::string land_text(const std::string& inside, bool is_static = true) {
  return std::string("<sdf version=\"1.9\"><world name=\"w\"><model name=\"land\"><static>") +
         (is_static ? "true" : "false") +
         "</static><link name=\"l\"><collision "
         "name=\"c\"><geometry><heightmap><uri>land.png</uri>" +
         inside + "</heightmap></geometry></collision></link></model></world></sdf>";
}

Built land(const std::string& inside, std::uint32_t side, const Levels& levels) {
  return built(land_text(inside), {{"land.png", test::gray_png(side, side, levels)}});
}

/// 5 by 5 points 1 m apart, from 0 in the corner at -x, +y, 1 m higher with each column, half a meter
/// with each row downward: 6 m in the opposite corner, which has 240.
Built slope() {
  Levels levels;
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 5; ++column) {
      levels.push_back(static_cast<std::uint8_t>(40 * column + 20 * row));
    }
  }
  return land("<size>4 4 6</size><pos>10 20 -3</pos>", 5, levels);
}

double slope_at(double x, double y) { return -3 + (x - 8) + (22 - y) / 2; }

TEST(Heightmap, ItsCornersAreAsHighAsThePictureSays) {
  const Built b = slope();
  ASSERT_FALSE(b.blocked);
  ASSERT_EQ(b.scene.shapes.size(), 1U);
  const auto& grid = std::get<HeightGrid>(b.scene.shapes[0].kind);
  EXPECT_NEAR(grid.heights.front(), 2, 1e-12);  // at -x, -y
  EXPECT_NEAR(grid.heights[4], 6, 1e-12);       // at +x, -y
  EXPECT_NEAR(grid.heights.back(), 4, 1e-12);   // at +x, +y
  EXPECT_EQ(b.scene.shapes[0].X_BS.translation, (model::Vector3{10, 20, -3}));
  // A ball whose center is nine tenths of its radius above the slope is a tenth of it deep.
  const double nz = 1 / std::sqrt(1 + 1 + 0.25);
  for (const auto& [x, y] : {std::pair{8.1, 18.1}, {11.9, 18.1}, {8.1, 21.9}, {11.9, 21.9}}) {
    simulate::Scene scene = b.scene;
    scene.models.push_back({.name = "ball", .base = 0});
    hand::add_body(scene, hand::ball_mass(1, 0.05), {x, y, slope_at(x, y) + 0.045 / nz});
    scene.bodies[0].model = 1;
    hand::add_shape(scene, 0, mesh::Sphere{0.05});
    simulate::OdeEngine engine(scene, {});
    engine.touch();
    ASSERT_EQ(engine.state().contacts.size(), 1U) << x << ' ' << y;
    EXPECT_NEAR(engine.state().contacts[0].depth, 0.005, 1e-4) << x << ' ' << y;
  }
}

/// A ball that rolls has 5/7 of the acceleration of one that slides: here of g · sin, with a slope of
/// √1.25 to 1 along (-1, 0.5).
TEST(Heightmap, ABallRollsDownItsSlope) {
  simulate::Scene scene = slope().scene;
  scene.models.push_back({.name = "ball", .base = 0});
  const double nz = 1 / std::sqrt(2.25);
  hand::add_body(scene, hand::ball_mass(1, 0.1), {11, 19.5, slope_at(11, 19.5) + 0.1 / nz});
  scene.bodies[0].model = 1;
  hand::add_shape(scene, 0, mesh::Sphere{0.1}).surface.mu = 2;
  scene.shapes[0].surface.mu = scene.shapes[0].surface.mu2 = 2;
  scene.shapes[1].surface.mu2 = 2;
  simulate::OdeEngine engine(scene, hand::stiff());
  for (int i = 0; i < 500; ++i) engine.step(simulate::Forces::kNone);
  const double sine = std::sqrt(1.25 / 2.25);
  const double way = 5.0 / 7 * 9.8 * sine * 0.5 * 0.5 / 2;
  const auto p = engine.state().bodies[0].p_WBcm - model::Vector3{11, 19.5, 0};
  EXPECT_NEAR(p.x, -way * nz / std::sqrt(1.25), 0.03 * way);
  EXPECT_NEAR(p.y, way * nz * 0.5 / std::sqrt(1.25), 0.03 * way);
}

/// Between two slopes of 1 to 2 a ball of half a meter rests where it touches both: its center is
/// r / cos above their line.
TEST(Heightmap, ABallSettlesInAValley) {
  Levels levels;
  for (int row = 0; row < 5; ++row) {
    for (const int level : {200, 100, 0, 100, 200}) {
      levels.push_back(static_cast<std::uint8_t>(level));
    }
  }
  simulate::Scene scene = land("<size>8 8 2</size>", 5, levels).scene;
  scene.models.push_back({.name = "ball", .base = 0});
  hand::add_body(scene, hand::ball_mass(1, 0.5), {0, 0.3, 0.7});
  scene.bodies[0].model = 1;
  hand::add_shape(scene, 0, mesh::Sphere{0.5});
  simulate::OdeEngine engine(scene, {});
  for (int i = 0; i < 1500; ++i) engine.step(simulate::Forces::kNone);
  const simulate::BodyState& ball = engine.state().bodies[0];
  EXPECT_NEAR(ball.p_WBcm.z, 0.5 * std::sqrt(1.25), 0.002);
  EXPECT_NEAR(ball.p_WBcm.x, 0, 1e-3);
  EXPECT_NEAR(length(ball.v_WBcm), 0, 5e-3);
}

/// As libsdformat's users see it: the brightest pixel is as high as the size says, whatever its level.
TEST(Heightmap, TheBrightestIsTheHighest) {
  const Built dim = land("<size>1 1 7</size>", 3, {0, 0, 0, 0, 10, 0, 0, 0, 0});
  EXPECT_NEAR(std::get<HeightGrid>(dim.scene.shapes[0].kind).heights[4], 7, 1e-12);
  const Built black = land("<size>1 1 7</size>", 3, Levels(9, 0));
  EXPECT_EQ(std::get<HeightGrid>(black.scene.shapes[0].kind).heights, std::vector<double>(9, 0.0));
}

std::string why_left_out(const Built& b) {
  for (const simulate::Fact& fact : b.facts) {
    if (fact.kind == FactKind::kShapeIgnored) return fact.name;
  }
  return {};
}

TEST(Heightmap, WhatGazeboRefusesIsLeftOutAndSaid) {
  EXPECT_EQ(why_left_out(land("", 4, Levels(16, 9))),
            "a heightmap of 4 by 4 pixels: Gazebo takes a square of 2^n + 1, as 129 by 129");
  const std::string oblong = test::gray_png(5, 3, Levels(15, 9));
  EXPECT_NE(why_left_out(built(land_text(""), {{"land.png", oblong}})).find("5 by 3"),
            std::string::npos);
  EXPECT_EQ(why_left_out(built(land_text(""))), "the heightmap's image land.png is not found");
  EXPECT_NE(why_left_out(built(land_text(""), {{"land.png", "GIF89a"}})).find("is no PNG"),
            std::string::npos);
  const std::string square = test::gray_png(3, 3, Levels(9, 9));
  EXPECT_EQ(why_left_out(built(land_text("", false), {{"land.png", square}})),
            "a heightmap that moves");
  EXPECT_TRUE(land("<size>0 1 1</size>", 3, Levels(9, 9)).blocked);
}

}  // namespace
}  // namespace rigor
