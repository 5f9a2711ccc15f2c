// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// EdgeBalance, Winding and Topology on meshes whose facts are counted by hand.

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mesh/topology/edge_balance.h>
#include <rigor/mesh/topology/topology.h>
#include <rigor/mesh/topology/winding.h>

#include "support/meshes.h"

namespace rigor::mesh {
namespace {

using test::box_mesh;
using test::joined;
using test::torus_mesh;
using test::turned;

bool closed(const TriangleMesh& mesh) {
  EdgeBalance balance;
  for (const Triangle& t : mesh.triangles) balance.add(facet(mesh, t));
  return balance.closed();
}

Winding winding(const TriangleMesh& mesh) {
  WindingProbe probe(bounds_of(mesh.positions));
  for (const Triangle& t : mesh.triangles) probe.add(facet(mesh, t));
  return probe.result();
}

TEST(EdgeBalance, AClosedMeshBalancesInAnyOrder) {
  TriangleMesh torus = torus_mesh(0.2, 0.06, 40, 24);
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    std::shuffle(torus.triangles.begin(), torus.triangles.end(), random);
    EXPECT_TRUE(closed(torus));
  }
}

TEST(EdgeBalance, EachMissingOrTurnedTriangleIsSeen) {
  const TriangleMesh torus = torus_mesh(0.2, 0.06, 12, 8);
  for (std::size_t i = 0; i < torus.triangles.size(); ++i) {
    TriangleMesh open = torus;
    open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(closed(open));
    TriangleMesh flipped = torus;
    std::swap(flipped.triangles[i][0], flipped.triangles[i][1]);
    EXPECT_FALSE(closed(flipped));
  }
}

TEST(EdgeBalance, MinusZeroIsZero) {
  TriangleMesh box = box_mesh({2, 2, 2}, {1, 1, 1});
  // Each triangle with its own corners, every other zero negative.
  TriangleMesh loose;
  for (std::size_t i = 0; i < box.triangles.size(); ++i) {
    for (const std::uint32_t corner : box.triangles[i]) {
      Vector3 p = box.positions[corner];
      if (i % 2 == 0 && p.x == 0) p.x = -0.0;
      loose.positions.push_back(p);
    }
    const auto n = static_cast<std::uint32_t>(3 * i);
    loose.triangles.push_back({n, n + 1, n + 2});
  }
  EXPECT_TRUE(closed(loose));
}

/// Meshes whose every edge meets its reverse, though no triangle has an area.
std::vector<TriangleMesh> meshes_without_area() {
  const std::vector<Vector3> line{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}};
  return {{},
          {.positions = line},
          {.positions = line, .triangles = {{0, 0, 0}}},
          {.positions = line, .triangles = {{0, 1, 1}, {2, 2, 0}}},
          {.positions = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, .triangles = {{0, 1, 2}}},
          {.positions = line, .triangles = {{0, 1, 2}, {0, 2, 1}}}};
}

TEST(EdgeBalance, WithoutAnAreaNothingIsClosed) {
  for (const TriangleMesh& mesh : meshes_without_area()) {
    EXPECT_FALSE(closed(mesh));
    EXPECT_TRUE(closed(joined(mesh, box_mesh({1, 2, 3})))) << "a box with them is";
  }
}

TEST(EdgeBalance, PartsJoinInAnyOrder) {
  const TriangleMesh box = box_mesh({1, 2, 3});
  EdgeBalance some;
  EdgeBalance rest;
  for (std::size_t i = 0; i < box.triangles.size(); ++i) {
    (i % 3 == 0 ? some : rest).add(facet(box, box.triangles[i]));
  }
  EdgeBalance none;
  EXPECT_FALSE(some.closed());
  none.join(some);
  none.join(rest);
  EXPECT_TRUE(none.closed());
}

TEST(Winding, OnceIsOnce) {
  const Winding found = winding(torus_mesh(0.2, 0.06, 40, 24));
  EXPECT_EQ(found.doubled, 0);
  EXPECT_EQ(found.inverted, 0);
  EXPECT_GT(found.lines, 100);
}

TEST(Winding, AMeshThatIsThereTwiceIsCountedTwice) {
  const TriangleMesh torus = torus_mesh(0.2, 0.06, 40, 24);
  EXPECT_NEAR(winding(joined(torus, torus)).doubled, 1, 1e-12);
}

TEST(Winding, OverlapIsItsShareOfTheInside) {
  // Two cubes of side 2 that share a slab of width 0.5: 4 of 16 - 2 = 14 units of inside, twice.
  const TriangleMesh both = joined(box_mesh({2, 2, 2}), box_mesh({2, 2, 2}, {1.5, 0.01, 0.01}));
  const double shared = 0.5 * 1.99 * 1.99;
  EXPECT_NEAR(winding(both).doubled, shared / (16 - shared), 0.03);
}

TEST(Winding, ACavityIsNoOverlap) {
  const Winding found = winding(joined(box_mesh({2, 2, 2}), turned(box_mesh({1, 1, 1}))));
  EXPECT_EQ(found.doubled, 0);
  EXPECT_EQ(found.inverted, 0);
}

TEST(Winding, InsideOut) { EXPECT_EQ(winding(turned(torus_mesh(0.2, 0.06, 40, 24))).inverted, 1); }

TEST(Topology, ABoxIsClosed) {
  const Topology box = topology_of(box_mesh({1, 2, 3}));
  EXPECT_EQ(box.vertices, 8U);
  EXPECT_EQ(box.edges, 18U);
  EXPECT_EQ(box.components, 1U);
  EXPECT_TRUE(box.closed());
}

TEST(Topology, CountsWhatIsOpen) {
  TriangleMesh open = box_mesh({1, 2, 3});
  open.triangles.pop_back();
  EXPECT_EQ(topology_of(open).boundary_edges, 3U);
  TriangleMesh flipped = box_mesh({1, 2, 3});
  std::swap(flipped.triangles[5][0], flipped.triangles[5][1]);
  EXPECT_EQ(topology_of(flipped).inconsistent_edges, 3U);
  TriangleMesh degenerate = box_mesh({1, 2, 3});
  degenerate.triangles.push_back({0, 0, 1});
  EXPECT_EQ(topology_of(degenerate).degenerate, 1U);
  EXPECT_TRUE(topology_of(degenerate).closed());
}

TEST(Topology, WithoutAnAreaNothingIsClosed) {
  for (const TriangleMesh& mesh : meshes_without_area()) {
    EXPECT_EQ(topology_of(mesh).boundary_edges, 0U) << "else this test is of no use";
    EXPECT_FALSE(topology_of(mesh).watertight());
    EXPECT_FALSE(topology_of(mesh).closed());
    EXPECT_TRUE(topology_of(joined(mesh, box_mesh({1, 2, 3}))).closed()) << "a box with them is";
  }
}

TEST(Topology, WatertightIsClosedOrTurned) {
  TriangleMesh box = box_mesh({1, 2, 3});
  EXPECT_TRUE(topology_of(box).watertight());
  std::swap(box.triangles[5][0], box.triangles[5][1]);
  EXPECT_TRUE(topology_of(box).watertight());
  EXPECT_FALSE(topology_of(box).closed());
  box.triangles.pop_back();
  EXPECT_FALSE(topology_of(box).watertight());
}

TEST(Topology, TwoBoxesAtAnEdge) {
  // They share the two corners of one edge, at which four triangles meet.
  const Topology found = topology_of(joined(box_mesh({1, 1, 1}), box_mesh({1, 1, 1}, {1, 1, 0})));
  EXPECT_EQ(found.nonmanifold_edges, 1U);
  EXPECT_EQ(found.vertices, 14U);
  EXPECT_EQ(topology_of(joined(box_mesh({1, 1, 1}), box_mesh({1, 1, 1}, {5, 0, 0}))).components,
            2U);
}

}  // namespace
}  // namespace rigor::mesh
