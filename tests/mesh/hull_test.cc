// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/convex/hull.h>

#include <random>

#include <gtest/gtest.h>

#include <rigor/mesh/topology/topology.h>

#include "support/meshes.h"

namespace rigor::mesh {
namespace {

double hull_volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Facet f = facet(mesh, t);
    sum += dot(f[0], cross(f[1], f[2])) / 6;
  }
  return sum;
}

TEST(Hull, OfABoxAndWhatIsInsideIsTheBox) {
  std::vector<Vector3> points = test::box_mesh({1, 2, 3}, {10, 0, 0}).positions;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> inside(-0.4, 0.4);
  for (int i = 0; i < 500; ++i)
    points.push_back({10 + inside(random), inside(random), inside(random)});
  const auto hull = convex_hull(points);
  ASSERT_TRUE(hull);
  EXPECT_EQ(hull->positions.size(), 8U);
  EXPECT_EQ(hull->triangles.size(), 12U);
  EXPECT_NEAR(hull_volume(*hull), 6, 1e-12);
  EXPECT_TRUE(topology_of(*hull).closed());
}

TEST(Hull, HoldsEveryPoint) {
  std::mt19937 random(5);
  std::normal_distribution<double> anywhere(0, 1);
  std::vector<Vector3> points;
  for (int i = 0; i < 2000; ++i) {
    points.push_back({anywhere(random), anywhere(random), 1e-2 * anywhere(random)});
  }
  const auto hull = convex_hull(points);
  ASSERT_TRUE(hull);
  EXPECT_TRUE(topology_of(*hull).closed());
  for (const Triangle& t : hull->triangles) {
    const Facet f = facet(*hull, t);
    const Vector3 normal = cross(f[1] - f[0], f[2] - f[0]);
    for (const Vector3& p : points) EXPECT_LE(dot(normal, p - f[0]), 1e-12);
  }
}

TEST(Hull, OfWhatIsFlatIsNothing) {
  EXPECT_FALSE(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}}));
  EXPECT_FALSE(convex_hull(std::vector<Vector3>(10, Vector3{1, 2, 3})));
  EXPECT_FALSE(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, std::nan("")}}));
}

}  // namespace
}  // namespace rigor::mesh
