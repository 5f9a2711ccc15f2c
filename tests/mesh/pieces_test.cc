// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Concave bodies whose convex pieces are known, and real ones whose pieces must be close.

#include <rigor/mesh/convex/pieces.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mesh/primitive/principal_axes.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/repair/cap.h>
#include <rigor/mesh/topology/topology.h>
#include <rigor/text/disk.h>

#include "mesh/bodies.h"
#include "support/corpus.h"
#include "support/part.h"
#include "support/workers.h"

namespace rigor::mesh {
namespace {

using std::numbers::pi;

/// How far a point lies above a face at most.
double outside(const TriangleMesh& hull, const Vector3& p) {
  double most = -1e300;
  for (const Triangle& t : hull.triangles) {
    const Facet f = facet(hull, t);
    const Vector3 normal = cross(f[1] - f[0], f[2] - f[0]);
    most = std::max(most, dot((1 / length(normal)) * normal, p - f[0]));
  }
  return most;
}

/// Each piece is convex and closed, and each vertex of the mesh in some piece.
void expect_sound(const Pieces& pieces, const TriangleMesh& mesh) {
  double sum = 0;
  for (const TriangleMesh& hull : pieces.hulls) {
    const double size = diagonal(bounds_of(hull.positions));
    double above = 0;
    for (const Vector3& p : hull.positions) above = std::max(above, outside(hull, p));
    EXPECT_LE(above, 1e-9 * size);
    EXPECT_TRUE(topology_of(hull).closed());
    EXPECT_GT(enclosed_volume(hull), 0);
    sum += enclosed_volume(hull);
  }
  EXPECT_NEAR(pieces.hull_volume, sum, 1e-12 * sum);
  double lost = 0;
  for (const Vector3& p : mesh.positions) {
    double nearest = 1e300;
    for (const TriangleMesh& hull : pieces.hulls) {
      nearest = std::min(nearest, outside(hull, p));
      if (nearest <= 0) break;
    }
    lost = std::max(lost, nearest);
  }
  EXPECT_LE(lost, 1e-6 * diagonal(bounds_of(mesh.positions)));
}

/// A prism along y: `profile` is a polygon in x and z, counter-clockwise seen from -y.
TriangleMesh prism(const std::vector<std::pair<double, double>>& profile, double width) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(profile.size());
  for (const double y : {-width / 2, width / 2}) {
    for (const auto& [x, z] : profile) mesh.positions.push_back({x, y, z});
  }
  std::vector<DirectedEdge> edges;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    edges.push_back({i, j});
    mesh.triangles.push_back({i, j + n, j});
    mesh.triangles.push_back({i, i + n, j + n});
  }
  for (const Triangle& t : cap_of(edges, mesh.positions, {0, -1, 0})) {
    mesh.triangles.push_back(t);
    mesh.triangles.push_back({t[0] + n, t[2] + n, t[1] + n});
  }
  return mesh;
}

TriangleMesh u_mesh() {
  return prism({{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}, 2);
}

/// A truck four long: a cab behind, and two wheel wells that go a third of the width deep from either
/// side. `wells` is the volume that they take.
struct Chassis {
  TriangleMesh mesh;
  double volume;
};

Chassis chassis() {
  constexpr unsigned kArc = 12;
  constexpr double kRadius = 0.45;
  Chassis result{{}, 0};
  TriangleMesh& mesh = result.mesh;
  // The profile, with where its edges belong to a well.
  std::vector<std::pair<double, double>> profile = {{0, 0}};
  std::vector<std::uint32_t> well_starts;
  for (const double center : {0.8, 3.1}) {
    well_starts.push_back(static_cast<std::uint32_t>(profile.size()));
    for (unsigned i = 0; i <= kArc; ++i) {
      const double angle = pi * i / kArc;
      profile.emplace_back(center - kRadius * std::cos(angle),
                           i % kArc == 0 ? 0 : kRadius * std::sin(angle));
    }
  }
  for (const auto& p : {std::pair(4.0, 0.0), {4.0, 1.0}, {1.5, 1.0}, {1.5, 2.0}, {0.0, 2.0}})
    profile.push_back(p);
  const auto n = static_cast<std::uint32_t>(profile.size());
  const auto in_well = [&](std::uint32_t i) {
    return std::any_of(well_starts.begin(), well_starts.end(),
                       [i](std::uint32_t first) { return i >= first && i < first + kArc; });
  };
  for (const double y : {-0.9, -0.3, 0.3, 0.9}) {
    for (const auto& [x, z] : profile) mesh.positions.push_back({x, y, z});
  }
  const auto quad = [&](std::uint32_t i, std::uint32_t j, std::uint32_t strip) {
    const std::uint32_t at = strip * n;
    mesh.triangles.push_back({at + i, at + n + j, at + j});
    mesh.triangles.push_back({at + i, at + n + i, at + n + j});
  };
  std::vector<DirectedEdge> side;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    side.push_back({i, j});
    quad(i, j, 0);
    if (!in_well(i)) quad(i, j, 1);
    quad(i, j, 2);
  }
  for (const Triangle& t : cap_of(side, mesh.positions, {0, -1, 0})) {
    mesh.triangles.push_back(t);
    mesh.triangles.push_back({t[0] + 3 * n, t[2] + 3 * n, t[1] + 3 * n});
  }
  for (const std::uint32_t first : well_starts) {
    quad(first, first + kArc, 1);  // the floor between the wells
    for (std::uint32_t i = first + 1; i < first + kArc; ++i) {
      mesh.triangles.push_back({n + first, n + i + 1, n + i});
      mesh.triangles.push_back({2 * n + first, 2 * n + i, 2 * n + i + 1});
    }
  }
  const double well = kArc / 2.0 * kRadius * kRadius * std::sin(pi / kArc);
  result.volume = (4 + 1.5) * 1.8 - 4 * well * 0.6;
  return result;
}

TEST(Pieces, OfWhatIsConvexIsOne) {
  for (const TriangleMesh& mesh : {box_mesh({1, 2, 3}), ball_mesh(1, 24, 12)}) {
    const Pieces pieces = convex_pieces(mesh, {});
    ASSERT_EQ(pieces.hulls.size(), 1U);
    EXPECT_NEAR(pieces.outside().value(), 0, 1e-12);
    EXPECT_EQ(pieces.hulls[0].positions.size(), mesh.positions.size());
    expect_sound(pieces, mesh);
  }
}

TEST(Pieces, OfAnLAreTwoAndOfAUThreeAndNothingIsOutside) {
  const Pieces l = convex_pieces(bracket_mesh(), {});
  EXPECT_EQ(l.hulls.size(), 2U);
  EXPECT_NEAR(l.outside().value(), 0, 1e-12);
  EXPECT_NEAR(l.mesh_volume.value(), 10, 1e-12);
  expect_sound(l, bracket_mesh());
  const Pieces u = convex_pieces(u_mesh(), {});
  EXPECT_EQ(u.hulls.size(), 3U);
  EXPECT_NEAR(u.mesh_volume.value(), 2 * (15 - 6), 1e-12);
  EXPECT_NEAR(u.outside().value(), 0, 1e-12);
  expect_sound(u, u_mesh());
}

TEST(Pieces, AreTheSameWhereverTheBodyIs) {
  TriangleMesh far = moved(u_mesh(), {1000, -500, 70});
  for (Vector3& p : far.positions) {
    p = rotate(model::from_rpy(0.3, -1.1, 2), p);
    p = {double(float(p.x)), double(float(p.y)), double(float(p.z))};
  }
  const Pieces pieces = convex_pieces(far, {});
  EXPECT_EQ(pieces.hulls.size(), 3U);
  EXPECT_NEAR(pieces.outside().value(), 0, 1e-2);
  expect_sound(pieces, far);
}

TEST(Pieces, OfATorus) {
  const TriangleMesh torus = torus_mesh(2, 0.6, 24, 16);
  const Pieces pieces = convex_pieces(torus, {});
  EXPECT_LE(pieces.hulls.size(), 16U);
  EXPECT_LE(pieces.outside().value(), 0.1 * pieces.mesh_volume.value());
  expect_sound(pieces, torus);
  // Fewer hold more.
  const Pieces four = convex_pieces(torus, {.count = 4});
  EXPECT_EQ(four.hulls.size(), 4U);
  EXPECT_GT(four.outside().value(), pieces.outside().value());
  const Pieces one = convex_pieces(torus, {.count = 1});
  EXPECT_EQ(one.hulls.size(), 1U);
  expect_sound(one, torus);
}

TEST(Pieces, OfAChassisWithWheelWells) {
  const Chassis body = chassis();
  ASSERT_TRUE(topology_of(body.mesh).closed());
  const Pieces pieces = convex_pieces(body.mesh, {});
  EXPECT_NEAR(pieces.mesh_volume.value(), body.volume, 1e-12);
  EXPECT_LE(pieces.hulls.size(), 16U);
  EXPECT_LE(pieces.outside().value(), 0.1 * body.volume);
  expect_sound(pieces, body.mesh);
}

TEST(Pieces, WallsRoundACavity) {
  const TriangleMesh box = joined(box_mesh({4, 4, 4}), turned(box_mesh({3, 3, 3})));
  const Pieces pieces = convex_pieces(box, {});
  EXPECT_EQ(pieces.solids, 1U);
  EXPECT_NEAR(pieces.mesh_volume.value(), 64 - 27, 1e-12);
  EXPECT_LE(pieces.hulls.size(), 6U);
  EXPECT_NEAR(pieces.outside().value(), 0, 1e-9);
  expect_sound(pieces, box);
}

TEST(Pieces, OfSolidsThatAreApartAndInsideOut) {
  const TriangleMesh two = joined(box_mesh({1, 1, 1}), turned(box_mesh({1, 1, 1}, {5, 0, 0})));
  const Pieces pieces = convex_pieces(two, {});
  EXPECT_EQ(pieces.solids, 2U);
  EXPECT_EQ(pieces.hulls.size(), 2U);
  EXPECT_NEAR(pieces.mesh_volume.value(), 2, 1e-12);
  EXPECT_NEAR(convex_pieces(two, {.count = 1}).outside().value(), 4, 1e-12);
  // Boxes that make up a longer one are one.
  EXPECT_EQ(
      convex_pieces(joined(box_mesh({1, 1, 1}), box_mesh({1, 1, 1}, {1, 0, 0})), {}).hulls.size(),
      1U);
}

TEST(Pieces, AnOpenMeshIsNotCutAndHasNoVolume) {
  TriangleMesh open = bracket_mesh();
  open.triangles.pop_back();
  const Pieces pieces = convex_pieces(open, {});
  EXPECT_EQ(pieces.open, 1U);
  EXPECT_EQ(pieces.hulls.size(), 1U);
  EXPECT_FALSE(pieces.mesh_volume);
  EXPECT_FALSE(pieces.outside());
  expect_sound(pieces, open);
}

TEST(Pieces, OfNothingAndOfWhatIsFlat) {
  EXPECT_TRUE(convex_pieces({}, {}).hulls.empty());
  const Pieces flat = convex_pieces({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}}, {});
  EXPECT_TRUE(flat.hulls.empty());
  EXPECT_EQ(flat.flat, 1U);
}

TEST(Pieces, OfTooManySolidsIsOne) {
  TriangleMesh dust;
  for (int i = 0; i <= int(kMaxSolids); ++i) {
    const Vector3 at{2.0 * (i % 10), 2.0 * (i / 10 % 10), 2.0 * (i / 100)};
    dust = joined(std::move(dust), box_mesh({1, 1, 1}, at));
  }
  const Pieces pieces = convex_pieces(dust, {});
  EXPECT_EQ(pieces.solids, kMaxSolids + 1);
  EXPECT_EQ(pieces.too_large, kMaxSolids + 1);
  EXPECT_EQ(pieces.hulls.size(), 1U);
  EXPECT_NEAR(pieces.mesh_volume.value(), kMaxSolids + 1, 1e-9);
  expect_sound(pieces, dust);
}

TEST(Pieces, AreTheSameEveryTime) {
  const Pieces once = convex_pieces(chassis().mesh, {.count = 8});
  const Pieces again = convex_pieces(chassis().mesh, {.count = 8});
  ASSERT_EQ(once.hulls.size(), again.hulls.size());
  for (std::size_t i = 0; i < once.hulls.size(); ++i) {
    EXPECT_EQ(once.hulls[i].positions, again.hulls[i].positions);
    EXPECT_EQ(once.hulls[i].triangles, again.hulls[i].triangles);
  }
}

TEST(Pieces, OfRealConcaveBodies) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  int tried = 0;
  for (const char* path :
       {"SO-ARM100/Simulation/SO100/assets/Moving_Jaw.stl",
        "dex-urdf/robots/hands/allegro_hand/meshes/visual/link_0.0.obj",
        "example-robot-data/robots/bolt_description/meshes/stl/"
        "lower_leg_200mm_left_side.stl",
        "gazebo_models/fire_hose_long/meshes/coupling2.stl", "trimesh/models/quadknot.obj"}) {
    if (test::parts() > 1 && ++tried > 2) break;
    SCOPED_TRACE(path);
    const LoadedMesh loaded = read_mesh(disk, test::corpus() + "/" + path, test::workers());
    ASSERT_TRUE(loaded.usable());
    ASSERT_TRUE(topology_of(loaded.mesh).closed());
    const Pieces whole = convex_pieces(loaded.mesh, {.count = 1});
    EXPECT_LT(whole.mesh_volume.value(), 0.8 * whole.hull_volume);
    const Pieces pieces = convex_pieces(loaded.mesh, {});
    EXPECT_LE(pieces.hulls.size(), 16U);
    EXPECT_LE(pieces.outside().value(), 0.1 * pieces.mesh_volume.value());
    expect_sound(pieces, loaded.mesh);
    RecordProperty(std::filesystem::path(path).filename().stem().string(),
                   std::to_string(pieces.outside().value() / pieces.mesh_volume.value()));
  }
}

}  // namespace
}  // namespace rigor::mesh
