// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Holes, the triangles that fill them, and holes that are none.

#include <rigor/mesh/repair/fill_holes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mesh/repair/loop_filling.h>
#include <rigor/mesh/topology/holes.h>

#include "mesh/bodies.h"

namespace rigor::mesh {
namespace {

constexpr double kHalfCircle = 3.141592653589793;
constexpr HoleLimits kAnySize{.max_area_share = 1};

double area(const Facet& f) { return length(cross(f[1] - f[0], f[2] - f[0])) / 2; }

double area_of(const Workpiece& work, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) sum += area({work.at(t[0]), work.at(t[1]), work.at(t[2])});
  return sum;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Component& c : topology_of(mesh).component_list) sum += c.volume;
  return sum;
}

TriangleMesh without(TriangleMesh mesh, std::vector<std::size_t> faces) {
  std::sort(faces.rbegin(), faces.rend());
  for (const std::size_t face : faces) {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(face));
  }
  return mesh;
}

std::vector<std::size_t> faces_at(const TriangleMesh& mesh, std::uint32_t vertex) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    if (std::count(t.begin(), t.end(), vertex) > 0) found.push_back(i);
  }
  return found;
}

/// A prism of height 1 upon a polygon, without its lid.
TriangleMesh open_prism(const std::vector<std::pair<double, double>>& polygon) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : polygon) mesh.positions.push_back({x, y, z});
  }
  mesh.positions.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({i, next, next + n});
    mesh.triangles.push_back({i, next + n, i + n});
    mesh.triangles.push_back({2 * n, next, i});  // seen from 0, 0 by all polygons here
  }
  return mesh;
}

double area_of(const std::vector<std::pair<double, double>>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& [x, y] = polygon[i];
    const auto& [u, v] = polygon[(i + 1) % polygon.size()];
    twice += x * v - u * y;
  }
  return twice / 2;
}

/// Points round 0, 0, at radii that jump.
std::vector<std::pair<double, double>> star(unsigned n, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::pair<double, double>> points;
  for (unsigned i = 0; i < n; ++i) {
    const double r = std::uniform_real_distribution<>(1, 2)(random);
    points.push_back(
        {r * std::cos(2 * kHalfCircle * i / n), r * std::sin(2 * kHalfCircle * i / n)});
  }
  return points;
}

TEST(LoopFilling, AStarIsFilledWithinItsBorder) {
  for (const unsigned n : {3U, 4U, 7U, 20U, 60U}) {
    for (unsigned seed = 0; seed < 5; ++seed) {
      const auto polygon = star(n, seed);
      const Workpiece work(open_prism(polygon));
      const std::vector<Hole> holes = holes_of(work);
      ASSERT_EQ(holes.size(), 1U);
      for (const auto& triangles : {best_filling(work, holes[0]), ear_filling(work, holes[0])}) {
        ASSERT_EQ(triangles.size(), n - 2);
        EXPECT_NEAR(area_of(work, triangles), area_of(polygon), 1e-12);
        for (const Triangle& t : triangles) {
          const Vector3 up = cross(work.at(t[1]) - work.at(t[0]), work.at(t[2]) - work.at(t[0]));
          EXPECT_GT(up.z, 0);
        }
      }
    }
  }
}

TEST(LoopFilling, ADartIsNotFoldedThoughThatIsSmaller) {
  const std::vector<std::pair<double, double>> dart = {{0, 5}, {-1, -5}, {0, -4}, {1, -5}};
  const Workpiece work(open_prism(dart));
  for (const Hole& hole : holes_of(work)) {
    EXPECT_NEAR(area_of(work, best_filling(work, hole)), area_of(dart), 1e-12);
    EXPECT_NEAR(area_of(work, ear_filling(work, hole)), area_of(dart), 1e-12);
  }
}

double square(const Workpiece& work, std::uint32_t a, std::uint32_t b) {
  const Vector3 v = work.at(a) - work.at(b);
  return dot(v, v);
}

/// The least sum of squared longest edges of all fillings of the stretch from i to k, each tried.
double least(const Workpiece& work, const std::vector<std::uint32_t>& loop, std::size_t i,
             std::size_t k) {
  if (k < i + 2) return 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t j = i + 1; j < k; ++j) {
    const double size = std::max({square(work, loop[i], loop[j]), square(work, loop[j], loop[k]),
                                  square(work, loop[i], loop[k])});
    best = std::min(best, size + least(work, loop, i, j) + least(work, loop, j, k));
  }
  return best;
}

TEST(LoopFilling, OnFlatGroundNoFillingIsSmaller) {
  for (unsigned n = 4; n < 11; ++n) {
    std::vector<std::pair<double, double>> polygon;
    for (unsigned i = 0; i < n; ++i) {  // convex, and not regular
      const double u = 2 * kHalfCircle * i / n + 0.2 * std::sin(3.0 * i);
      polygon.push_back({2 * std::cos(u), std::sin(u)});
    }
    const Workpiece work(open_prism(polygon));
    const Hole hole = holes_of(work).at(0);
    double size = 0;
    for (const Triangle& t : best_filling(work, hole)) {
      size +=
          std::max({square(work, t[0], t[1]), square(work, t[1], t[2]), square(work, t[2], t[0])});
    }
    EXPECT_NEAR(size, least(work, hole.vertices, 0, n - 1), 1e-12);
  }
}

TEST(FillHoles, LongLoopsAreFilledToo) {
  const auto polygon = star(400, 1);
  Workpiece work(open_prism(polygon));
  const HolesFilled done = fill_holes(work, kAnySize);
  EXPECT_EQ(done.filled, 1U);
  EXPECT_EQ(done.triangles, 398U);
  EXPECT_NEAR(done.area, area_of(polygon), 1e-12);
  const TriangleMesh mesh = std::move(work).finished();
  EXPECT_TRUE(topology_of(mesh).closed());
  EXPECT_NEAR(volume(mesh), area_of(polygon), 1e-12);
}

TEST(FillHoles, AMissingTriangleComesBack) {
  const TriangleMesh ball = ball_mesh(1, 16, 9);
  for (std::size_t face = 0; face < ball.triangles.size(); face += 7) {
    Workpiece work(without(ball, {face}));
    const HolesFilled done = fill_holes(work, {});
    EXPECT_EQ(done.filled, 1U);
    EXPECT_EQ(done.triangles, 1U);
    EXPECT_NEAR(done.area, area(facet(ball, ball.triangles[face])), 1e-15);
    const TriangleMesh mesh = std::move(work).finished();
    EXPECT_EQ(counts(topology_of(mesh)), counts(topology_of(ball)));
    EXPECT_NEAR(volume(mesh), volume(ball), 1e-14);
  }
}

TEST(FillHoles, WithoutAVertexTheBodyIsSmallerByNoMoreThanTheCone) {
  const TriangleMesh ball = ball_mesh(1, 24, 13);
  for (std::uint32_t vertex = 0; vertex < ball.positions.size(); vertex += 5) {
    Workpiece work(without(ball, faces_at(ball, vertex)));
    const HolesFilled done = fill_holes(work, kAnySize);
    const TriangleMesh mesh = std::move(work).finished();
    ASSERT_TRUE(topology_of(mesh).closed());
    double spoke = 0;
    for (const std::size_t face : faces_at(ball, vertex)) {
      for (const std::uint32_t corner : ball.triangles[face]) {
        spoke = std::max(spoke, length(ball.positions[corner] - ball.positions[vertex]));
      }
    }
    // Between them is a cone from the vertex to the filling, of a convex body: the vertex is above it
    // by no more than a ball of radius 1 rises over a chord of two spokes.
    const double lost = volume(ball) - volume(mesh);
    EXPECT_GT(lost, 0);
    EXPECT_LT(lost, done.area / 3 * (1 - std::sqrt(1 - spoke * spoke)));
  }
}

TEST(FillHoles, HolesThatTouchAreFilledApart) {
  const TriangleMesh torus = torus_mesh(2, 0.6, 24, 16);
  const std::vector<std::size_t> round = faces_at(torus, 100);
  ASSERT_EQ(round.size(), 6U);
  for (const std::vector<std::size_t>& faces : {std::vector{round[0], round[3]},
                                                {round[0], round[5]},
                                                {round[0], round[2], round[4]},
                                                {round[1], round[2], round[5]}}) {
    TriangleMesh open = without(torus, faces);
    for (unsigned seed = 0; seed < 20; ++seed) {  // walks begin anywhere
      std::mt19937 random(seed);
      std::shuffle(open.triangles.begin(), open.triangles.end(), random);
      Workpiece work(open);
      std::size_t edges = 0;
      for (const Hole& hole : holes_of(work)) {
        edges += hole.vertices.size();
        const std::set<std::uint32_t> different(hole.vertices.begin(), hole.vertices.end());
        EXPECT_EQ(different.size(), hole.vertices.size());
      }
      EXPECT_EQ(edges, work.defects().boundary_edges);
      fill_holes(work, {});
      const TriangleMesh mesh = std::move(work).finished();
      EXPECT_EQ(counts(topology_of(mesh)), counts(topology_of(torus)));
      EXPECT_NEAR(volume(mesh), volume(torus), 0.01 * area(facet(torus, torus.triangles[0])));
    }
  }
}

TEST(FillHoles, BodiesThatTouchInAVertexStayTwo) {
  // Each misses a triangle at their common corner.
  const TriangleMesh mesh =
      joined(without(box_mesh({1, 1, 1}), {11}), without(box_mesh({1, 1, 1}, {1, 1, 1}), {0}));
  ASSERT_EQ(topology_of(mesh).nonmanifold_vertices, 1U);
  Workpiece work(mesh);
  EXPECT_EQ(fill_holes(work, kAnySize).filled, 2U);
  const Topology after = topology_of(std::move(work).finished());
  EXPECT_TRUE(after.closed());
  EXPECT_EQ(after.components, 2U);
  EXPECT_EQ(after.nonmanifold_vertices, 1U);
  EXPECT_NEAR(after.component_list[0].volume, 1, 1e-15);
  EXPECT_NEAR(after.component_list[1].volume, 1, 1e-15);
}

TEST(FillHoles, ACrackAtAVertexOnAnEdgeIsClosedWithoutAFlatTriangle) {
  // The top of a box is cut from the middle of one of its edges, the side below is not.
  TriangleMesh mesh = without(box_mesh({2, 2, 2}), {2, 3});
  mesh.positions.push_back({0.25, -1, 1});
  mesh.positions.push_back({-0.5, -1, 1});
  mesh.triangles.insert(mesh.triangles.end(), {{4, 9, 6}, {9, 8, 6}, {8, 7, 6}, {8, 5, 7}});
  ASSERT_EQ(topology_of(mesh).boundary_edges, 4U);
  Workpiece work(mesh);
  const HolesFilled done = fill_holes(work, {});
  EXPECT_EQ(done.filled, 1U);
  EXPECT_NEAR(done.area, 0, 1e-15);
  EXPECT_EQ(work.defects(), DefectCounts{});
  const TriangleMesh whole = std::move(work).finished();
  EXPECT_NEAR(volume(whole), 8, 1e-14);
  EXPECT_EQ(topology_of(whole).euler(), 2);
}

TEST(FillHoles, ACupStaysOpenAndASheetASheet) {
  Workpiece cup(without(box_mesh({2, 2, 2}), {2, 3}));
  const HolesFilled kept = fill_holes(cup, {});
  EXPECT_EQ(kept.filled, 0U);
  EXPECT_EQ(kept.too_large, 1U);
  TriangleMesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.01}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  Workpiece work(joined(sheet, moved(ball_mesh(30, 16, 9), {99, 0, 0})));
  EXPECT_EQ(fill_holes(work, {}).too_large, 1U);
  EXPECT_EQ(work.defects().boundary_edges, 4U);
}

TEST(FillHoles, LimitsAreKept) {
  const TriangleMesh torus = torus_mesh(2, 0.6, 24, 16);
  Workpiece few(without(torus, faces_at(torus, 100)));
  EXPECT_EQ(fill_holes(few, {.max_edges = 5}).too_large, 1U);
  EXPECT_EQ(fill_holes(few, {.max_edges = 6}).filled, 1U);
  // Three triangles of which two are within the limit; the smaller ones are first.
  const std::vector<std::size_t> faces = {0, 16, 100};
  std::vector<double> areas;
  double left = 0;
  for (const std::size_t face : faces) areas.push_back(area(facet(torus, torus.triangles[face])));
  const TriangleMesh open = without(torus, faces);
  for (const Triangle& t : open.triangles) left += area(facet(open, t));
  std::sort(areas.begin(), areas.end());
  Workpiece some(open);
  const HolesFilled done =
      fill_holes(some, {.max_area_share = (areas[0] + areas[1] + areas[2] / 2) / left});
  EXPECT_EQ(done.filled, 2U);
  EXPECT_EQ(done.too_large, 1U);
  EXPECT_NEAR(done.area, areas[0] + areas[1], 1e-14);
}

TEST(FillHoles, PlacesThatAreNoneAreLeft) {
  TriangleMesh mesh = without(ball_mesh(1, 16, 9), {0});
  mesh.positions[mesh.triangles[0][0]].x = std::numeric_limits<double>::quiet_NaN();
  Workpiece work(mesh);
  const std::uint64_t open = work.defects().boundary_edges;
  fill_holes(work, {});
  EXPECT_LE(work.defects().boundary_edges, open);
}

}  // namespace
}  // namespace rigor::mesh
