// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/polyline.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mass/quadrature.h"

namespace rigor::mass {
namespace {

using test::expect_close;

constexpr double kExactPrism = 1e-14;

Outline rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}};
}

Outline reversed(Outline outline) {
  std::reverse(outline.begin(), outline.end());
  return outline;
}

/// What a box at (x0, y0)-(x1, y1) from z = 0 is.
MassProperties brick(double x0, double y0, double x1, double y1, double height) {
  return translated({(x0 + x1) / 2, (y0 + y1) / 2, height / 2},
                    of_density(box({x1 - x0, y1 - y0, height}), 1));
}

Solid as_solid(const MassProperties& body) {
  return {body.mass, body.com, (1 / body.mass) * body.about_com};
}

TEST(Polyline, RectanglesAreBoxes) {
  const Outline outline = rectangle(-1, 2, 3, 2.5);
  const Solid expected = as_solid(brick(-1, 2, 3, 2.5, 0.25));
  for (const Outline& way : {outline, reversed(outline)}) {
    const auto solid = extruded({way}, 0.25);
    ASSERT_TRUE(solid);
    expect_close(*solid, expected, kExactPrism);
  }
}

TEST(Polyline, TriangleByHand) {
  // Right triangle of legs 3 and 6: center at a third, ∫x²/A about it 3²/18, ∫xy/A -3·6/36.
  const auto solid = extruded({{{0, 0, 0}, {3, 0, 0}, {0, 6, 0}}}, 2);
  ASSERT_TRUE(solid);
  EXPECT_DOUBLE_EQ(solid->volume, 18);
  EXPECT_DOUBLE_EQ(solid->com.x, 1);
  EXPECT_DOUBLE_EQ(solid->com.y, 2);
  EXPECT_DOUBLE_EQ(solid->com.z, 1);
  EXPECT_DOUBLE_EQ(solid->unit_inertia.izz, 0.5 + 2);
  EXPECT_DOUBLE_EQ(solid->unit_inertia.ixx, 2 + 1.0 / 3);
  EXPECT_DOUBLE_EQ(solid->unit_inertia.ixy, 0.5);
}

TEST(Polyline, AnAngleIsTwoBricks) {
  const auto solid = extruded(
      {{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}, {0, 0, 0}}}, 0.5);
  ASSERT_TRUE(solid);
  expect_close(*solid, as_solid(add(brick(0, 0, 4, 1, 0.5), brick(0, 1, 1, 3, 0.5))), kExactPrism);
}

TEST(Polyline, HolesAndIslandsWhicheverWayTheyAreWound) {
  const Outline plate = rectangle(0, 0, 10, 10);
  const Outline hole = rectangle(1, 2, 7, 8);
  const Outline island = rectangle(2, 3, 4, 5);
  const MassProperties expected =
      add(subtract(brick(0, 0, 10, 10, 1), brick(1, 2, 7, 8, 1)), brick(2, 3, 4, 5, 1));
  for (const auto& outlines :
       {std::vector{plate, hole, island}, std::vector{island, reversed(hole), plate},
        std::vector{reversed(plate), reversed(island), hole}}) {
    const auto solid = extruded(outlines, 1);
    ASSERT_TRUE(solid);
    expect_close(*solid, as_solid(expected), kExactPrism);
  }
}

TEST(Polyline, RegularPolygonsBecomeCylinders) {
  // A regular n-gon has izz/m = r² (2 + cos 2π/n)/6 (CRC tables, as two right triangles a side).
  for (const int n : {3, 8, 64}) {
    Outline outline;
    for (int i = 0; i < n; ++i) {
      outline.push_back({5 + std::cos(2 * test::kPi * i / n), std::sin(2 * test::kPi * i / n), 0});
    }
    const auto solid = extruded({outline}, 2);
    ASSERT_TRUE(solid);
    EXPECT_NEAR(solid->unit_inertia.izz, (2 + std::cos(2 * test::kPi / n)) / 6, kExactPrism);
    EXPECT_NEAR(solid->volume, n * std::sin(2 * test::kPi / n), 100 * kExactPrism);
    EXPECT_NEAR(solid->unit_inertia.ixy, 0, kExactPrism);
  }
}

TEST(Polyline, FarFromItsOrigin) {
  Outline near{{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.25, 0}, {0.125, 0.5, 0}};
  Outline far = near;
  for (model::Vector3& p : far) p = p + model::Vector3{1024, -2048, 0};
  const auto a = extruded({near}, 0.1);
  const auto b = extruded({far}, 0.1);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->volume, b->volume);
  EXPECT_EQ(a->unit_inertia, b->unit_inertia);
}

TEST(Polyline, RefusesWhatCrossesOrTouchesItself) {
  const model::Vector3 a{0, 0, 0}, b{2, 0, 0}, c{2, 2, 0}, d{0, 2, 0}, middle{1, 1, 0};
  EXPECT_FALSE(extruded({{a, c, b, d}}, 1));                  // a bow tie
  EXPECT_FALSE(extruded({{a, middle, c, b, middle, d}}, 1));  // with a corner where it crosses
  EXPECT_FALSE(extruded({{a, b, {3, 0, 0}, b, c}}, 1));       // a spike
  EXPECT_FALSE(extruded({{a, {3, 0, 0}, b, c}}, 1));          // back over its first side
  EXPECT_FALSE(extruded({{a, b, {-1, 0, 0}, c}}, 1));         // and beyond it
  EXPECT_FALSE(extruded({{a, b, c, {1, 0, 0}}}, 1));          // touches its first side
  EXPECT_FALSE(extruded({{a, b, c, d, a, b, c, d}}, 1));      // twice round
  EXPECT_FALSE(extruded({rectangle(0, 0, 2, 2), rectangle(1, 1, 3, 3)}, 1));
  EXPECT_FALSE(extruded({rectangle(0, 0, 2, 2), rectangle(0, 0, 2, 2)}, 1));
  EXPECT_FALSE(extruded({rectangle(0, 0, 2, 2), rectangle(2, 0.5, 4, 1)}, 1));
  EXPECT_FALSE(
      extruded({{a, {4, 0, 0}, c}, {{1, -2, 0}, {3, -2, 0}, {2, 1, 0}}}, 1));  // a tip pokes in
  EXPECT_TRUE(extruded({{a, b, c, d}}, 1));
  EXPECT_TRUE(extruded({{a, {1, 0, 0}, b, b, c, d, a, a}}, 1));  // a corner on a side, and repeats
}

TEST(Polyline, RefusesWhatHasNoVolume) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Outline square = rectangle(0, 0, 1, 1);
  EXPECT_FALSE(extruded({}, 1));
  EXPECT_FALSE(extruded({Outline{}}, 1));
  EXPECT_FALSE(extruded({square, Outline{}}, 1));
  EXPECT_FALSE(extruded({{{0, 0, 0}, {1, 0, 0}}}, 1));
  EXPECT_FALSE(extruded({{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}}, 1));
  for (const double height : {0.0, -1.0, std::nan(""), kInfinity}) {
    EXPECT_FALSE(extruded({square}, height)) << height;
  }
  EXPECT_FALSE(extruded({{{0, 0, 0}, {kInfinity, 0, 0}, {0, 1, 0}}}, 1));
  EXPECT_FALSE(extruded({{{0, 0, 0}, {1, std::nan(""), 0}, {0, 1, 0}}}, 1));
}

TEST(Polyline, HasABound) {
  Outline circle(kMaxSides + 1);
  for (std::size_t i = 0; i < circle.size(); ++i) {
    const double angle =
        2 * test::kPi * static_cast<double>(i) / static_cast<double>(circle.size());
    circle[i] = {std::cos(angle), std::sin(angle), 0};
  }
  EXPECT_FALSE(extruded({circle}, 1));
  circle.pop_back();
  EXPECT_TRUE(extruded({circle}, 1));
}

TEST(Polyline, OfAShape) {
  model::Polyline shape;
  for (const model::Vector3& p : rectangle(0, 0, 1, 2)) shape.points.push_back({p, {}, true});
  shape.height.value = 3;
  for (const auto& solid : {mass::solid_of(shape), mass::solid_of(model::Shape(shape))}) {
    ASSERT_TRUE(solid);
    EXPECT_DOUBLE_EQ(solid->volume, 6);
    EXPECT_EQ(solid->com, (model::Vector3{0.5, 1, 1.5}));
  }
}

}  // namespace
}  // namespace rigor::mass
