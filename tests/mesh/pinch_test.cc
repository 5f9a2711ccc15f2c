// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/repair/pinch.h>

#include <cstdint>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mesh/topology/topology.h>

namespace rigor::mesh {
namespace {

/// A wedge's outline, seen from outside, on the edge from place 0 to place 1: two sides and two ends.
void add_wedge(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
               std::vector<Triangle>& faces) {
  // The places c and d lie beyond the middle of the edge a b; the fourth face closes it.
  faces.insert(faces.end(), {{a, b, c}, {b, a, d}, {c, d, a}, {d, c, b}});
}

/// Two tetrahedra that touch along the edge from place 0 to place 1, and a place in its middle.
struct Pinched {
  std::vector<Vector3> places = {{0, 0, 0},  {4, 0, 0}, {2, -3, 1}, {2, -3, -1},
                                 {2, 3, -1}, {2, 3, 1}, {2, 0, 0}};
  std::vector<Triangle> faces;
  // Of the mesh that this is left of: its triangle has the place in the middle.
  std::vector<std::uint32_t> corners = {0, 6, 2};

  Pinched() {
    add_wedge(0, 1, 3, 2, faces);
    add_wedge(0, 1, 5, 4, faces);
  }

  PinchedSurface surface() const {
    std::vector<std::uint32_t> places_of_vertices(places.size());
    std::iota(places_of_vertices.begin(), places_of_vertices.end(), 0U);
    PinchedSurface surface(places, places_of_vertices);
    surface.take(faces);
    return surface;
  }
};

Topology topology(const PinchedSurface& surface) {
  TriangleMesh mesh;
  mesh.positions = surface.places();
  mesh.triangles = surface.faces();
  return topology_of(mesh);
}

bool any(const BadEdge&) { return true; }

TEST(Pinch, FourTrianglesAtAnEdgeGetTwoEdges) {
  const Pinched pinched;
  PinchedSurface surface = pinched.surface();
  const std::vector<BadEdge> edges = surface.bad_edges();
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_EQ(edges[0].defect, Defect::kNonmanifoldEdge);
  EXPECT_TRUE(surface.part(edges, any, pinched.corners, 10).empty());
  EXPECT_EQ(surface.faces().size(), 10U);
  const Topology after = topology(surface);
  EXPECT_TRUE(after.closed());
  EXPECT_EQ(after.nonmanifold_vertices, 0U);
  EXPECT_EQ(after.components, 1U);  // they are grown together, as at a waist
  EXPECT_EQ(after.euler(), 2);
}

TEST(Pinch, NoMoreTrianglesThanAllowed) {
  const Pinched pinched;
  PinchedSurface surface = pinched.surface();
  EXPECT_EQ(surface.part(surface.bad_edges(), any, pinched.corners, 9).size(), 1U);
  EXPECT_EQ(surface.faces(), pinched.faces);
}

TEST(Pinch, OnlyAVertexThatTheEndsWereJoinedTo) {
  const Pinched pinched;
  PinchedSurface surface = pinched.surface();
  EXPECT_EQ(surface.part(surface.bad_edges(), any, {2, 3, 6}, 10).size(), 1U);
  EXPECT_EQ(surface.part(surface.bad_edges(), any, {0, 2, 3}, 10).size(), 1U);  // in use
  EXPECT_EQ(surface.faces(), pinched.faces);
}

TEST(Pinch, ATetrahedronThatHangsOnAnEdgeIsTaken) {
  const Pinched pinched;
  PinchedSurface surface = pinched.surface();
  EXPECT_TRUE(surface.mend(surface.bad_edges(), any).empty());
  EXPECT_EQ(surface.faces().size(), 4U);
  EXPECT_TRUE(topology(surface).closed());
}

TEST(Pinch, WhatIsNotChosenIsLeft) {
  const Pinched pinched;
  PinchedSurface surface = pinched.surface();
  const auto none = [](const BadEdge&) { return false; };
  EXPECT_EQ(surface.mend(surface.bad_edges(), none).size(), 1U);
  EXPECT_EQ(surface.part(surface.bad_edges(), none, pinched.corners, 10).size(), 1U);
  EXPECT_EQ(surface.faces(), pinched.faces);
}

}  // namespace
}  // namespace rigor::mesh
