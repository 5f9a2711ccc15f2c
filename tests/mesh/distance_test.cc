// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/spatial/distance.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mesh/bodies.h"
#include "support/meshes.h"

namespace rigor::mesh {
namespace {

constexpr double kRounding = 1e-12;

/// The square from 0 to `side` in x and y, at this height.
TriangleMesh square_mesh(double side, double z) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, z}, {side, 0, z}, {side, side, z}, {0, side, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(DeviationTest, OfTheSameSurfaceIsNone) {
  for (const Body& body : bodies()) {
    EXPECT_NEAR(deviation(body.mesh, body.mesh, 1000).hausdorff(), 0, kRounding) << body.name;
  }
  // Nor of the same surface in other triangles.
  TriangleMesh other = square_mesh(2, 1);
  other.triangles = {{0, 1, 3}, {1, 2, 3}};
  EXPECT_NEAR(deviation(square_mesh(2, 1), other, 1000).hausdorff(), 0, kRounding);
}

TEST(DeviationTest, OfParallelSquaresIsWhatIsBetween) {
  const Deviation d = deviation(square_mesh(2, 0), square_mesh(2, 0.125), 100);
  EXPECT_NEAR(d.from_a, 0.125, kRounding);
  EXPECT_NEAR(d.from_b, 0.125, kRounding);
  EXPECT_TRUE(d.complete);
}

TEST(DeviationTest, OfABoxInABoxIsGreaterFromOutside) {
  const Deviation d = deviation(box_mesh({2, 2, 2}), box_mesh({2.2, 2.2, 2.2}), 1000);
  EXPECT_NEAR(d.from_a, 0.1, kRounding);
  EXPECT_NEAR(d.from_b, 0.1 * std::sqrt(3), kRounding);  // corner to corner
  EXPECT_NEAR(d.hausdorff(), 0.1 * std::sqrt(3), kRounding);
}

TEST(DeviationTest, OfConcentricBallsIsTheDifferenceOfTheirRadii) {
  // A ball of this many corners dips below its sphere by less than a hundredth.
  const Deviation d = deviation(ball_mesh(1, 60, 30), ball_mesh(1.5, 60, 30), 5000);
  EXPECT_NEAR(d.from_a, 0.5, 0.01);
  EXPECT_NEAR(d.from_b, 0.5, 0.01);
}

TEST(DeviationTest, OfAPartIsSeenFromTheWholeAlone) {
  const Deviation d = deviation(square_mesh(1, 0), square_mesh(3, 0), 1000);
  EXPECT_NEAR(d.from_a, 0, kRounding);
  EXPECT_NEAR(d.from_b, 2 * std::sqrt(2), kRounding);
}

TEST(DeviationTest, ADentIsFoundBySamplesBetweenCorners) {
  // A square whose middle is pulled down by 1: above it, the flat one is 1 / sqrt(2) from a flank.
  TriangleMesh dented = square_mesh(2, 0);
  dented.positions.push_back({1, 1, -1});
  dented.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const double exact = 1 / std::sqrt(2);
  const TriangleMesh flat = square_mesh(2, 0);
  EXPECT_NEAR(deviation(flat, dented, 0).from_a, 0, kRounding);  // corners alone don't tell
  for (const std::size_t samples : {100U, 1000U, 10000U}) {
    const Deviation d = deviation(flat, dented, samples);
    EXPECT_LE(d.from_a, exact + kRounding);
    EXPECT_GE(d.from_a, exact - d.spacing);
    EXPECT_NEAR(d.from_b, 1, kRounding);
  }
}

TEST(DeviationTest, SpacingIsASquareOfSurfaceASample) {
  EXPECT_NEAR(deviation(square_mesh(1, 0), square_mesh(3, 0), 900).spacing, 0.1, kRounding);
}

TEST(DeviationTest, TurnsRoundWithItsMeshes) {
  const TriangleMesh a = torus_mesh(2, 0.6, 24, 16);
  const TriangleMesh b = torus_mesh(2, 0.6, 17, 11);
  const Deviation there = deviation(a, b, 3000);
  const Deviation back = deviation(b, a, 3000);
  EXPECT_EQ(there.from_a, back.from_b);
  EXPECT_EQ(there.from_b, back.from_a);
  EXPECT_GT(there.from_a, 0.02);
}

TEST(DeviationTest, FromNothingIsNoneAndToNothingInfinite) {
  const Deviation d = deviation(box_mesh({1, 1, 1}), {}, 100);
  EXPECT_EQ(d.from_a, std::numeric_limits<double>::infinity());
  EXPECT_EQ(d.from_b, 0);
  EXPECT_EQ(deviation({}, {}, 100).hausdorff(), 0);
}

TEST(DeviationTest, MoreSamplesThanTheMostAreSaid) {
  const Deviation d = deviation(square_mesh(1, 0), {}, kMaxSamples + 1);
  EXPECT_FALSE(d.complete);
}

TEST(DeviationTest, TrianglesWithoutAnAreaAreAsGoodAsTheirCorners) {
  TriangleMesh line;
  line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}, {1, 1, 1}};
  const Deviation d = deviation(line, square_mesh(2, 3), 100);
  EXPECT_NEAR(d.from_a, 3, kRounding);
  EXPECT_NEAR(d.from_b, std::sqrt(9 + 4), kRounding);
}

}  // namespace
}  // namespace rigor::mesh
