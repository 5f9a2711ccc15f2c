// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Halves of bodies: their volumes add up, they are closed, and some are known in closed form.

#include <rigor/mesh/convex/plane_cut.h>

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include <rigor/mesh/primitive/principal_axes.h>
#include <rigor/mesh/topology/edge_balance.h>
#include <rigor/mesh/topology/topology.h>

#include "mesh/bodies.h"

namespace rigor::mesh {
namespace {

/// A plane that misses a body leaves one half empty.
bool closed_or_empty(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return true;
  EdgeBalance balance;
  for (const Triangle& t : mesh.triangles) balance.add(facet(mesh, t));
  return balance.closed();
}

Plane random_plane(std::mt19937& random, const TriangleMesh& mesh) {
  std::normal_distribution<double> n(0, 1);
  Plane plane{{n(random), n(random), n(random)}, 0};
  plane.normal = (1 / length(plane.normal)) * plane.normal;
  const Vector3& through = mesh.positions[random() % mesh.positions.size()];
  plane.offset = dot(plane.normal, through) + 0.1 * n(random);
  return plane;
}

TEST(PlaneCut, VolumesOfHalvesAddUpAndHalvesAreClosed) {
  std::mt19937 random(7);
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    const double whole = enclosed_volume(body.mesh);
    for (int i = 0; i < 200; ++i) {
      const Plane plane = random_plane(random, body.mesh);
      const Halves halves = cut(body.mesh, plane);
      const double below = enclosed_volume(halves.below);
      const double above = enclosed_volume(halves.above);
      EXPECT_NEAR(below + above, whole, 1e-12 * whole);
      EXPECT_GE(below, -1e-15);
      EXPECT_GE(above, -1e-15);
      for (const TriangleMesh& half : {halves.below, halves.above}) {
        const Topology topology = topology_of(half);
        EXPECT_TRUE(topology.closed() || half.triangles.empty());
        EXPECT_EQ(topology.degenerate, 0U);
        EXPECT_EQ(topology.unreferenced, 0U);
      }
      for (const Vector3& p : halves.below.positions) {
        EXPECT_LE(dot(plane.normal, p), plane.offset + 1e-11);
      }
      for (const Vector3& p : halves.above.positions) {
        EXPECT_GE(dot(plane.normal, p), plane.offset - 1e-11);
      }
    }
  }
}

TEST(PlaneCut, HalfABall) {
  const TriangleMesh ball = ball_mesh(1, 128, 64);
  const double exact = 2.0 / 3 * std::numbers::pi;
  const double half = enclosed_volume(ball) / 2;
  EXPECT_NEAR(half, exact, 2e-3 * exact);
  // Through vertices and edges, across faces, and through the poles.
  for (const Vector3& normal :
       {Vector3{0, 0, 1}, Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0.6, 0, 0.8}}) {
    const Halves halves = cut(ball, {normal, 0});
    EXPECT_NEAR(enclosed_volume(halves.below), half, 1e-12);
    EXPECT_NEAR(enclosed_volume(halves.above), half, 1e-12);
    EXPECT_TRUE(topology_of(halves.below).closed());
    EXPECT_TRUE(topology_of(halves.above).closed());
  }
}

TEST(PlaneCut, ATorusIsHalvedAcrossAndAlong) {
  const TriangleMesh torus = torus_mesh(2, 0.6, 24, 16);
  const double half = enclosed_volume(torus) / 2;
  const Halves along = cut(torus, {{0, 0, 1}, 0});
  EXPECT_NEAR(enclosed_volume(along.above), half, 1e-12);
  EXPECT_EQ(topology_of(along.above).components, 1U);
  const Halves across = cut(torus, {{0, 1, 0}, 0});
  EXPECT_NEAR(enclosed_volume(across.above), half, 1e-12);
  // Two sections, a cap each.
  EXPECT_EQ(topology_of(across.above).euler(), 2);
}

TEST(PlaneCut, FacesInThePlaneGoToTheHalfTheyBound) {
  const TriangleMesh bracket = bracket_mesh();
  const Halves notch = cut(bracket, {{0, 1, 0}, 1});
  EXPECT_NEAR(enclosed_volume(notch.below), 6, 1e-12);
  EXPECT_NEAR(enclosed_volume(notch.above), 4, 1e-12);
  EXPECT_EQ(bounds_of(notch.above.positions).max, (Vector3{1, 3, 2}));
  EXPECT_TRUE(topology_of(notch.below).closed());
  EXPECT_TRUE(topology_of(notch.above).closed());
  const Halves top = cut(bracket, {{0, 0, 1}, 2});
  EXPECT_NEAR(enclosed_volume(top.below), 10, 1e-12);
  EXPECT_TRUE(top.above.triangles.empty());
  EXPECT_TRUE(topology_of(top.below).closed());
}

TEST(PlaneCut, CapsDoNotFoldOver) {
  std::mt19937 random(13);
  // Sections with holes, with islands in them, not star-shaped, and of many corners.
  const TriangleMesh rings =
      joined(joined(torus_mesh(2, 0.6, 24, 16), torus_mesh(5, 1.2, 40, 20)), ball_mesh(1, 16, 9));
  const TriangleMesh hollow = joined(ball_mesh(2, 20, 12), turned(ball_mesh(1.5, 16, 9)));
  for (const TriangleMesh& mesh : {rings, hollow, bracket_mesh(), moved(rings, {100, 0, 0})}) {
    for (int i = 0; i < 200; ++i) {
      Plane plane = random_plane(random, mesh);
      if (i % 4 == 0) plane.normal = {0, 0, 1}, plane.offset = 0.01 * (i - 50);
      const Halves halves = cut(mesh, plane);
      double area = 0;
      Vector3 sum;
      for (const Triangle& t : halves.below.triangles) {
        const Facet f = facet(halves.below, t);
        const auto off = [&plane](const Vector3& p) { return dot(plane.normal, p) - plane.offset; };
        if (std::max({std::abs(off(f[0])), std::abs(off(f[1])), std::abs(off(f[2]))}) > 1e-11)
          continue;
        const Vector3 normal = cross(f[1] - f[0], f[2] - f[0]);
        area += length(normal);
        sum = sum + normal;
      }
      EXPECT_NEAR(area, length(sum), 1e-9 * (1 + area));
    }
  }
}

TEST(PlaneCut, BesideTheBodyNothingIsCut) {
  const Halves halves = cut(bracket_mesh(), {{0, 0, 1}, -1});
  EXPECT_TRUE(halves.below.triangles.empty());
  EXPECT_EQ(halves.above.triangles.size(), bracket_mesh().triangles.size());
}

TEST(PlaneCut, NearVerticesCountAsOnThePlaneAsFarAsIsSaid) {
  TriangleMesh box = box_mesh({1, 1, 1});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-1e-7, 1e-7);
  for (Vector3& p : box.positions) p.z += noise(random);
  const Plane top{{0, 0, 1}, 0.5};
  EXPECT_TRUE(cut(box, top, kOnPlane32).above.triangles.empty());
  EXPECT_NEAR(enclosed_volume(cut(box, top, kOnPlane32).below), 1, 1e-6);
}

TEST(PlaneCut, CutAgainAndAgainNothingIsLost) {
  std::mt19937 random(11);
  for (const Body& body : bodies()) {
    std::vector<TriangleMesh> pieces = {body.mesh};
    for (int i = 0; i < 6; ++i) {
      const Plane plane = random_plane(random, body.mesh);
      std::vector<TriangleMesh> next;
      for (const TriangleMesh& piece : pieces) {
        Halves halves = cut(piece, plane);
        next.push_back(std::move(halves.below));
        next.push_back(std::move(halves.above));
      }
      pieces = std::move(next);
    }
    double sum = 0;
    for (const TriangleMesh& piece : pieces) {
      sum += enclosed_volume(piece);
      EXPECT_TRUE(closed_or_empty(piece));
    }
    EXPECT_NEAR(sum, enclosed_volume(body.mesh), 1e-11 * sum) << body.name;
  }
}

}  // namespace
}  // namespace rigor::mesh
