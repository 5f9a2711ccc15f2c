// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh/prism.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mass/polyhedron.h>
#include <rigor/mesh/topology/topology.h>

namespace rigor::mass {
namespace {

Outline square(double half, double x = 0) {
  return {{x - half, -half, 0}, {x + half, -half, 0}, {x + half, half, 0}, {x - half, half, 0}};
}

TEST(Prism, HasHolesAndIslands) {
  const Outline star{{0, 0, 0}, {4, 1, 0}, {8, 0, 0}, {5, 4, 0}, {4, 9, 0}, {3, 4, 0}};
  Outline backwards = square(2);
  std::reverse(backwards.begin(), backwards.end());
  Outline closed = square(1);
  closed.push_back(closed.front());
  const std::vector<std::vector<Outline>> cases{
      {square(1)},
      {star},
      {backwards},
      {closed},
      {square(3), square(1)},
      {square(3), backwards, square(1)},             // an island in a hole
      {square(3), square(0.5, -1), square(0.5, 1)},  // two holes
      {square(1, -5), square(1, 5)},
  };
  for (const auto& outlines : cases) {
    const auto solid = extruded(outlines, 0.5);
    const auto made = prism_mesh(outlines, 0.5);
    ASSERT_TRUE(solid);
    ASSERT_TRUE(made);
    EXPECT_TRUE(mesh::topology_of(*made).closed());
    PolyhedronSum sum(made->positions.front());
    for (const mesh::Triangle& t : made->triangles) sum.add(mesh::facet(*made, t));
    EXPECT_NEAR(sum.moments().volume, solid->volume, 1e-9);
    EXPECT_NEAR(solid_of(sum.moments()).com.x, solid->com.x, 1e-9);
    EXPECT_NEAR(solid_of(sum.moments()).com.z, 0.25, 1e-9);
    double area = 0;  // of both ends: no triangle folds over another
    for (const mesh::Triangle& t : made->triangles) {
      area += std::abs(mesh::area_vector(mesh::facet(*made, t)).z) / 2;
    }
    EXPECT_NEAR(area, 2 * solid->volume / 0.5, 1e-9);
  }
  EXPECT_FALSE(prism_mesh({{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}}, 1)) << "crosses itself";
  EXPECT_FALSE(prism_mesh({square(1)}, NAN));
}

/// A hole goes the other way round; what is solid turns only when it goes clockwise.
TEST(Prism, TellsWhichOutlinesHaveTheSolidOnTheRight) {
  Outline clockwise = square(2);
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_EQ(with_solid_on_the_right({square(3), square(1)}), (std::vector{false, true}));
  EXPECT_EQ(with_solid_on_the_right({square(3), clockwise, square(1)}),
            (std::vector{false, false, false}));
  EXPECT_EQ(with_solid_on_the_right({clockwise}), (std::vector{true}));
}

}  // namespace
}  // namespace rigor::mass
