// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/support_polygon.h>

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::mass {
namespace {

using Points = std::vector<GroundPoint>;

TEST(SupportPolygon, KeepsCornersOnly) {
  // A square with a point inside, one on each of two sides, and a corner twice.
  const SupportPolygon polygon({{2, 2}, {0, 0}, {1, 1}, {2, 0}, {1, 0}, {0, 2}, {0, 1}, {2, 2}});
  EXPECT_EQ(polygon.corners(), (Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(SupportPolygon, MarginByHand) {
  const SupportPolygon square({{0, 0}, {4, 0}, {4, 2}, {0, 2}});
  EXPECT_EQ(square.margin({2, 1}), 1);
  EXPECT_EQ(square.margin({0.25, 1}), 0.25);
  EXPECT_EQ(square.margin({0, 1}), 0);
  EXPECT_EQ(square.margin({-0.5, 1}), -0.5);
  EXPECT_EQ(square.margin({7, 6}), -5);  // from the corner: 3, 4, 5
  // On the right triangle (0,0) (4,0) (0,3), the incenter is (1, 1) and the inradius 1.
  EXPECT_NEAR(SupportPolygon({{0, 0}, {4, 0}, {0, 3}}).margin({1, 1}), 1, 1e-15);
}

TEST(SupportPolygon, LinesAndPointsSupportNothing) {
  const SupportPolygon line({{0, 0}, {2, 2}, {1, 1}});
  EXPECT_EQ(line.corners(), (Points{{0, 0}, {2, 2}}));
  EXPECT_EQ(line.margin({1, 1}), 0);
  EXPECT_NEAR(line.margin({1, 0}), -std::sqrt(0.5), 1e-15);
  const SupportPolygon point({{1, 1}, {1, 1}});
  EXPECT_EQ(point.corners(), (Points{{1, 1}}));
  EXPECT_EQ(point.margin({4, 5}), -5);
  EXPECT_EQ(SupportPolygon({}).margin({0, 0}), -std::numeric_limits<double>::infinity());
}

TEST(SupportPolygon, LeavesOutWhatIsNotFinite) {
  const double inf = std::numeric_limits<double>::infinity();
  const SupportPolygon polygon({{std::nan(""), 0}, {0, 0}, {inf, -inf}, {1, 0}, {0, -inf}, {0, 1}});
  EXPECT_EQ(polygon.corners(), (Points{{0, 0}, {1, 0}, {0, 1}}));
}

TEST(SupportPolygon, CircleKeepsAllItsPoints) {
  constexpr int kCount = 97;
  const double step = 2 * std::acos(-1.0) / kCount;
  Points circle;
  for (int i = 0; i < kCount; ++i) {
    circle.push_back(
        {std::cos(36 * i * step), std::sin(36 * i * step)});  // 36 and 97 share nothing
  }
  const SupportPolygon polygon(circle);
  EXPECT_EQ(polygon.corners().size(), circle.size());
  EXPECT_NEAR(polygon.margin({0, 0}), std::cos(step / 2), 1e-15);
}

}  // namespace
}  // namespace rigor::mass
