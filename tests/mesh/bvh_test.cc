// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/spatial/bvh.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/bodies.h"
#include "support/meshes.h"

namespace rigor::mesh {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

/// Coordinates of few digits, so that many boxes touch in a plane, an edge or a corner.
std::vector<Facet> scattered(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&random](unsigned n) {
    return 0.25 * static_cast<double>(random() % n);
  };
  std::vector<Facet> facets(count);
  for (Facet& f : facets) {
    const Vector3 at{coordinate(40), coordinate(40), coordinate(40)};
    for (Vector3& p : f) p = at + Vector3{coordinate(9), coordinate(9), coordinate(9)};
  }
  return facets;
}

Bounds box(const Facet& f) { return bounds_of(std::vector<Vector3>(f.begin(), f.end())); }

bool touch(const Bounds& a, const Bounds& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
         a.min.z <= b.max.z && b.min.z <= a.max.z;
}

Pairs pairs_by_indices(const Bvh& tree) {
  Pairs pairs;
  const bool complete = tree.pairs(kNoLimit, [&](std::uint32_t i, std::uint32_t j) {
    EXPECT_LT(i, j);
    const bool added = pairs.insert(std::minmax({tree.index(i), tree.index(j)})).second;
    EXPECT_TRUE(added);
    return true;
  });
  EXPECT_TRUE(complete);
  return pairs;
}

TEST(BvhTest, AnyNumberOfTrianglesIsThereOnce) {
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 63U, 64U, 65U, 513U, 1000U}) {
    const std::vector<Facet> facets = scattered(count, 3);
    const Bvh tree(facets);
    ASSERT_EQ(tree.size(), count);
    std::set<std::uint32_t> indices;
    for (std::uint32_t slot = 0; slot < count; ++slot) {
      indices.insert(tree.index(slot));
      EXPECT_EQ(tree.facet(slot), facets[tree.index(slot)]);
    }
    EXPECT_EQ(indices.size(), count);
  }
}

TEST(BvhTest, PairsAreThoseOfAllBoxes) {
  for (const std::size_t count : {0U, 1U, 2U, 8U, 9U, 65U, 700U}) {
    const std::vector<Facet> facets = scattered(count, 4);
    Pairs expected;
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t j = i + 1; j < count; ++j) {
        if (touch(box(facets[i]), box(facets[j]))) expected.emplace(i, j);
      }
    }
    EXPECT_EQ(pairs_by_indices(Bvh(facets)), expected) << count;
  }
}

TEST(BvhTest, BoxesThatFloatsRoundStillTouch) {
  // Apart by less than a float can tell, or touching where no float is.
  const double x = 0.1;
  const std::vector<Facet> facets{{Vector3{0, 0, 0}, {x, 0, 0}, {0, 1, 0}},
                                  {Vector3{x, 0, 0}, {1, 0, 0}, {1, 1, 0}}};
  EXPECT_EQ(pairs_by_indices(Bvh(facets)).size(), 1U);
}

TEST(BvhTest, PairsStopAtTheBudgetOrWhenTold) {
  const Bvh tree(scattered(700, 5));
  const std::size_t all = pairs_by_indices(tree).size();
  std::size_t seen = 0;
  const auto count = [&seen](std::uint32_t, std::uint32_t) { return ++seen > 0; };
  EXPECT_FALSE(tree.pairs(100, count));
  EXPECT_LE(seen, 100U);
  seen = 0;
  EXPECT_FALSE(tree.pairs(kNoLimit, [&](std::uint32_t, std::uint32_t) { return ++seen < 10; }));
  EXPECT_EQ(seen, 10U);
  EXPECT_GT(all, 100U);
}

TEST(BvhTest, TouchingAreThoseOfAllBoxes) {
  const std::vector<Facet> facets = scattered(700, 6);
  const Bvh tree(facets);
  for (const Facet& f : scattered(50, 7)) {
    std::set<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
      if (touch(box(f), box(facets[i]))) expected.insert(i);
    }
    std::set<std::uint32_t> found;
    tree.touching(box(f),
                  [&](std::uint32_t slot) { return found.insert(tree.index(slot)).second; });
    EXPECT_EQ(found, expected);
  }
}

TEST(BvhTest, NearestIsTheLeastOfAll) {
  const std::vector<Facet> facets = scattered(700, 8);
  const Bvh tree(facets);
  std::mt19937 random(9);
  const auto coordinate = [&random] { return 0.01 * static_cast<double>(random() % 2000) - 4; };
  for (int round = 0; round < 500; ++round) {
    const Vector3 p{coordinate(), coordinate(), coordinate()};
    double least = std::numeric_limits<double>::infinity();
    for (const Facet& f : facets) least = std::min(least, length(closest_point(f, p) - p));
    const Nearest near = tree.nearest(p, static_cast<std::uint32_t>(random() % 700));
    EXPECT_NEAR(near.distance, least, 1e-12);
    EXPECT_NEAR(length(closest_point(tree.facet(near.slot), p) - p), least, 1e-12);
    EXPECT_NEAR(length(near.at - p), least, 1e-12);
    const Nearest any = tree.nearest(p, 0, 2);
    EXPECT_LE(any.distance, std::max(2.0, least + 1e-12));
    EXPECT_LE(any.looks, near.looks + 700);
  }
}

TEST(BvhTest, NearestOfEqualsIsTheFirst) {
  const std::vector<Facet> facets(100, Facet{Vector3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Bvh tree(facets);
  for (const std::uint32_t guess : {0U, 50U, 99U}) {
    EXPECT_EQ(tree.index(tree.nearest({0.2, 0.2, 3}, guess).slot), 0U);
  }
}

TEST(BvhTest, FewTrianglesOfManyAreLookedAt) {
  const Bvh tree(torus_mesh(2, 0.6, 200, 100));
  EXPECT_EQ(tree.size(), 40000U);
  EXPECT_LT(tree.nearest({2, 0.5, 1}).looks, 400U);
}

TEST(BvhTest, TrianglesOutOfReachAreLeftOut) {
  TriangleMesh mesh = box_mesh({2, 2, 2});
  mesh.positions.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  mesh.positions.push_back({0, -std::numeric_limits<double>::infinity(), 0});
  mesh.positions.push_back({0, 0, 1e40});
  mesh.positions.push_back({0, 0, 1e30});
  mesh.triangles = {{0, 1, 8}, {0, 1, 9}, {0, 1, 10}, {0, 1, 11}, {0, 1, 2}};
  const Bvh tree(mesh);
  ASSERT_EQ(tree.size(), 2U);
  EXPECT_EQ(tree.index(0) + tree.index(1), 3U + 4U);
  EXPECT_EQ(tree.nearest({-1, -1, -1}).distance, 0);
}

TEST(ClosestPointTest, OnFaceEdgeAndCorner) {
  const Facet f{Vector3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_EQ(closest_point(f, {1, 1, 5}), (Vector3{1, 1, 0}));
  EXPECT_EQ(closest_point(f, {1, -2, 5}), (Vector3{1, 0, 0}));
  EXPECT_EQ(closest_point(f, {3, 3, -1}), (Vector3{2, 2, 0}));
  EXPECT_EQ(closest_point(f, {-1, -1, 1}), (Vector3{0, 0, 0}));
  EXPECT_EQ(closest_point(f, {9, -1, 1}), (Vector3{4, 0, 0}));
}

TEST(ClosestPointTest, AnObtuseTriangleHasFarEdges) {
  // Below the long edge's line, but next to its end.
  const Facet f{Vector3{0, 0, 0}, {10, 0, 0}, {-5, 1, 0}};
  EXPECT_EQ(closest_point(f, {-1, -5, 0}), (Vector3{0, 0, 0}));
  EXPECT_EQ(closest_point(f, {-7, 1, 0}), (Vector3{-5, 1, 0}));
}

TEST(ClosestPointTest, WithoutAnAreaAreLinesAndPoints) {
  EXPECT_EQ(closest_point({Vector3{0, 0, 0}, {1, 0, 0}, {5, 0, 0}}, {3, 2, 0}), (Vector3{3, 0, 0}));
  EXPECT_EQ(closest_point({Vector3{1, 1, 1}, {1, 1, 1}, {1, 1, 3}}, {0, 0, 2}), (Vector3{1, 1, 2}));
  EXPECT_EQ(closest_point({Vector3{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {0, 0, 2}), (Vector3{1, 1, 1}));
}

}  // namespace
}  // namespace rigor::mesh
