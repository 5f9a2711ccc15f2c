// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Turning triangles to agree, and bodies to face outward.

#include <rigor/mesh/repair/orient.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <rigor/mesh/select.h>

#include "mesh/bodies.h"

namespace rigor::mesh {
namespace {

TriangleMesh with_turned(TriangleMesh mesh, double share, unsigned seed) {
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (std::uniform_real_distribution<>()(random) < share) turn_over(mesh, i);
  }
  return mesh;
}

TriangleMesh consistent(const TriangleMesh& mesh) {
  Workpiece work(mesh);
  turn_consistent(work);
  return std::move(work).finished();
}

double oriented_volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Component& c : topology_of(mesh).component_list) sum += c.volume;
  return sum;
}

TEST(Orient, AnyShareOfTurnedTrianglesIsTurnedBack) {
  for (const Body& body : bodies()) {
    for (const double share : {0.05, 0.3, 0.5, 0.9, 1.0}) {
      for (unsigned seed = 0; seed < 5; ++seed) {
        SCOPED_TRACE(body.name + ", share " + std::to_string(share));
        TriangleMesh mesh = consistent(with_turned(body.mesh, share, seed));
        face_outward(mesh);
        EXPECT_TRUE(topology_of(mesh).closed());
        EXPECT_EQ(topology_of(mesh).inverted, 0U);
        EXPECT_NEAR(oriented_volume(mesh), oriented_volume(body.mesh),
                    1e-12 * oriented_volume(body.mesh));
      }
    }
  }
}

TEST(Orient, TheFewerAreTurned) {
  TriangleMesh mesh = ball_mesh(1, 16, 8);
  for (const std::size_t face : {3U, 40U, 77U}) turn_over(mesh, face);
  Workpiece work(mesh);
  EXPECT_EQ(turn_consistent(work), 3U);
  EXPECT_EQ(work.defects(), DefectCounts{});
  EXPECT_EQ(turn_consistent(work), 0U);
}

/// A band of `n` cells that closes with a half turn.
TriangleMesh moebius_strip(unsigned n) {
  constexpr double kPi = 3.141592653589793;
  TriangleMesh mesh;
  for (unsigned i = 0; i < n; ++i) {
    const double u = 2 * kPi * i / n;
    for (const double v : {-0.3, 0.3}) {
      const double r = 1 + v * std::cos(u / 2);
      mesh.positions.push_back({r * std::cos(u), r * std::sin(u), v * std::sin(u / 2)});
    }
  }
  for (unsigned i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const std::uint32_t a = 2 * i;
    const std::uint32_t c = last ? 1 : a + 2;
    const std::uint32_t d = last ? 0 : a + 3;
    mesh.triangles.push_back({a, c, d});
    mesh.triangles.push_back({a, d, a + 1});
  }
  return mesh;
}

TEST(Orient, AMoebiusStripKeepsOneSeam) {
  const TriangleMesh strip = moebius_strip(20);
  ASSERT_EQ(topology_of(strip).inconsistent_edges, 1U);
  EXPECT_EQ(topology_of(consistent(strip)).inconsistent_edges, 1U);
  const TriangleMesh mixed = with_turned(strip, 0.4, 1);
  ASSERT_GT(topology_of(mixed).inconsistent_edges, 2U);
  EXPECT_LE(topology_of(consistent(mixed)).inconsistent_edges, 2U);
}

TEST(Orient, WhatLiesInATurnedBodyIsTurnedWithIt) {
  // A hollow ball with a kernel, all inside out; a sound box beside; an inverted one.
  TriangleMesh mesh = joined(turned(ball_mesh(3, 16, 8)), ball_mesh(2, 16, 8));
  mesh = joined(mesh, turned(ball_mesh(1, 16, 8)));
  mesh = joined(mesh, box_mesh({1, 1, 1}, {9, 0, 0}));
  mesh = joined(mesh, turned(box_mesh({1, 1, 1}, {12, 0, 0})));
  EXPECT_EQ(face_outward(mesh), 4U);
  const Topology after = topology_of(mesh);
  EXPECT_EQ(after.inverted, 0U);
  EXPECT_EQ(after.cavities, 1U);
  EXPECT_EQ(after.doubled, 0U);
  EXPECT_GT(after.component_list[0].volume, 0);
  EXPECT_LT(after.component_list[1].volume, 0);
  EXPECT_GT(after.component_list[2].volume, 0);
  EXPECT_EQ(face_outward(mesh), 0U);
}

TEST(Orient, ABodyTwiceStaysTwice) {
  TriangleMesh mesh = turned(joined(box_mesh({4, 4, 4}), box_mesh({1, 1, 1})));
  EXPECT_EQ(face_outward(mesh), 2U);
  EXPECT_EQ(topology_of(mesh).doubled, 1U);
}

TEST(Orient, OpenSurfacesStay) {
  TriangleMesh mesh = turned(ball_mesh(1, 16, 8));
  mesh.triangles.pop_back();
  EXPECT_EQ(face_outward(mesh), 0U);
}

}  // namespace
}  // namespace rigor::mesh
