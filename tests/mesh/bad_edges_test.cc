// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Held against `look_round`, which walks round every vertex.

#include <rigor/mesh/topology/bad_edges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace rigor::mesh {
namespace {

void expect_bad_edges_of_rings(const TriangleMesh& mesh) {
  const Weld welded = weld(mesh.positions);
  DefectTally tally;
  const std::vector<BadEdge> expected = look_round(mesh, welded, tally).bad_edges;
  const std::vector<BadEdge> found = bad_edges_of(mesh, welded);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto all = [](const BadEdge& e) { return std::tuple(e.low, e.high, e.face, e.defect); };
    EXPECT_EQ(all(found[i]), all(expected[i])) << i;
  }
}

/// Triangles that run from the lower place to the higher, less those that run back.
int balance(const TriangleMesh& mesh, const Weld& welded, const BadEdge& edge) {
  int sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Triangle p = places_of(welded, t);
    if (degenerate(p)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      if (p[i] == edge.low && p[(i + 1) % 3] == edge.high) ++sum;
      if (p[i] == edge.high && p[(i + 1) % 3] == edge.low) --sum;
    }
  }
  return sum;
}

using Told = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, Defect>;

std::vector<Told> told(const std::vector<BadEdge>& edges) {
  std::vector<Told> all;
  for (const BadEdge& e : edges) all.emplace_back(e.low, e.high, e.face, e.defect);
  return all;
}

void expect_bad_edges_at(const TriangleMesh& mesh, const std::vector<std::uint32_t>& places) {
  const Weld welded = weld(mesh.positions);
  const std::vector<BadEdge> all = bad_edges_of(mesh, welded);
  std::vector<BadEdge> asked;
  std::vector<BadEdge> or_open;
  for (const BadEdge& edge : all) {
    const auto ends = [&](std::uint32_t at) { return at == edge.low || at == edge.high; };
    const bool at = std::any_of(places.begin(), places.end(), ends);
    if (at) asked.push_back(edge);
    if (at || balance(mesh, welded, edge) != 0) or_open.push_back(edge);
  }
  EXPECT_EQ(told(bad_edges_at(mesh, welded, places, false)), told(asked));
  const std::vector<Told> found = told(bad_edges_at(mesh, welded, places, true));
  const std::vector<Told> least = told(or_open);
  const std::vector<Told> most = told(all);
  EXPECT_TRUE(std::includes(found.begin(), found.end(), least.begin(), least.end()));
  EXPECT_TRUE(std::includes(most.begin(), most.end(), found.begin(), found.end()));
}

TEST(BadEdges, OfRandomTriangles) {
  std::mt19937 random(7);
  for (std::uint32_t places = 4; places < 40; ++places) {
    for (std::uint32_t triangles = 1; triangles < 120; triangles += 7) {
      TriangleMesh mesh;
      for (std::uint32_t i = 0; i < places; ++i) {
        mesh.positions.push_back({double{i < 3 ? 0.0 : i}, 0, 0});  // three of them in one place
      }
      for (std::uint32_t i = 0; i < triangles; ++i) {
        mesh.triangles.push_back({static_cast<std::uint32_t>(random() % places),
                                  static_cast<std::uint32_t>(random() % places),
                                  static_cast<std::uint32_t>(random() % places)});
      }
      expect_bad_edges_of_rings(mesh);
      expect_bad_edges_at(mesh, {});
      expect_bad_edges_at(mesh, {0, 1});
    }
  }
}

TEST(BadEdges, OfASurfaceWithFlaws) {
  TriangleMesh mesh = test::torus_mesh(2, 1, 30, 20);
  EXPECT_TRUE(bad_edges_of(mesh, weld(mesh.positions)).empty());
  std::swap(mesh.triangles[100][0], mesh.triangles[100][1]);
  mesh.triangles.push_back(mesh.triangles[300]);
  mesh.triangles.erase(mesh.triangles.begin() + 500);
  // Three edges turned the wrong way, three of three triangles, three of one.
  EXPECT_EQ(bad_edges_of(mesh, weld(mesh.positions)).size(), 9U);
  expect_bad_edges_of_rings(mesh);
  expect_bad_edges_at(mesh, {mesh.triangles[100][0]});
}

TEST(BadEdges, RoundAPlaceOfManyTriangles) {
  TriangleMesh mesh;
  mesh.positions.push_back({0, 0, 1});
  constexpr std::uint32_t kAround = 200;
  for (std::uint32_t i = 0; i < kAround; ++i) mesh.positions.push_back({1.0 * i, 1.0 * i * i, 0});
  for (std::uint32_t i = 0; i < kAround; ++i) {
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % kAround});
  }
  EXPECT_EQ(bad_edges_of(mesh, weld(mesh.positions)).size(), kAround);
  expect_bad_edges_of_rings(mesh);
}

}  // namespace
}  // namespace rigor::mesh
