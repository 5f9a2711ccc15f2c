// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/mass/polyhedron.h>
#include <rigor/mass/shapes.h>
#include <rigor/mesh/normals.h>
#include <rigor/mesh/primitive/primitive_mesh.h>

#include "drawing_fixture.h"

namespace rigor::view {
namespace {

using mesh::TriangleMesh;
using model::Vector3;

mass::PolyhedronMoments moments_of(TriangleMesh mesh, const Vector3& scale) {
  for (Vector3& p : mesh.positions) p = {scale.x * p.x, scale.y * p.y, scale.z * p.z};
  mass::PolyhedronSum sum(mesh.positions.front());
  for (const mesh::Triangle& t : mesh.triangles) sum.add(mesh::facet(mesh, t));
  return sum.moments();
}

/// Each place twice: once there, once back.
bool is_closed(const TriangleMesh& mesh) {
  std::map<std::array<std::array<double, 3>, 2>, int> edges;
  const auto key = [&mesh](std::uint32_t i) {
    const Vector3& p = mesh.positions[i];
    return std::array{p.x, p.y, p.z};
  };
  for (const mesh::Triangle& t : mesh.triangles) {
    for (const auto& [a, b] : mesh::kSides) {
      ++edges[{key(t[a]), key(t[b])}];
      --edges[{key(t[b]), key(t[a])}];
    }
  }
  for (const auto& [edge, count] : edges) {
    if (count != 0) return false;
  }
  return true;
}

TEST(DrawnShape, EnclosesWhatItsClosedFormSays) {
  // A 64-gon has sin(2π/64)/(2π/64) of its circle's area; a ball that is round both ways loses that twice.
  constexpr double angle = 2 * std::numbers::pi / mesh::kCircleSegments;
  const double round = std::sin(angle) / angle;
  const std::vector<std::pair<model::Shape, double>> shapes{
      {model::Box{.size = {.value = {1, 2, 3}}}, 1},
      {model::Sphere{.radius = {.value = 0.4}}, round * round},
      {model::Ellipsoid{.radii = {.value = {0.1, 0.5, 2}}}, round * round},
      {model::Cylinder{.radius = {.value = 0.3}, .length = {.value = 2}}, round},
      {model::Cone{.radius = {.value = 0.3}, .length = {.value = 2}}, round},
      {model::Capsule{.radius = {.value = 0.3}, .length = {.value = 2}}, round * round},
      {model::Capsule{.radius = {.value = 0.3}, .length = {.value = 0}}, round * round}};
  ShapeMeshes meshes;
  for (const auto& [shape, share] : shapes) {
    SCOPED_TRACE(model::shape_name(shape));
    const ShapeMesh drawn = meshes.of(shape);
    ASSERT_TRUE(drawn.mesh) << drawn.why;
    EXPECT_TRUE(is_closed(*drawn.mesh));
    const auto solid = mass::solid_of(shape);
    const auto moments = moments_of(*drawn.mesh, drawn.scale);
    const auto* capsule = std::get_if<model::Capsule>(&shape);
    const double volume = solid ? solid->volume : mass::sphere(capsule->radius.value).volume;
    EXPECT_LE(moments.volume, volume * (1 + 1e-12));
    EXPECT_GE(moments.volume, volume * share * (1 - 1e-3));
    if (!solid) continue;
    EXPECT_NEAR(mass::solid_of(moments).com.z, solid->com.z, 1e-9) << "the apex of a cone is above";
  }
}

TEST(DrawnShape, HasNormalsThatPointOutward) {
  ShapeMeshes meshes;
  const auto ball = meshes.of(model::Sphere{.radius = {.value = 1}}).mesh;
  ASSERT_EQ(ball->corners.normals.size(), ball->triangles.size());
  for (std::size_t i = 0; i < ball->triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vector3& p = ball->positions[ball->triangles[i][corner]];
      EXPECT_GT(dot(mesh::as_vector(ball->corners.normals[i][corner]), p), 0.999);
    }
  }
}

TEST(DrawnShape, PutsAPictureUprightOnTheSidesOfABox) {
  ShapeMeshes meshes;
  const auto box = meshes.of(model::Box{.size = {.value = {1, 1, 1}}}).mesh;
  ASSERT_EQ(box->corners.texture.size(), box->triangles.size());
  for (std::size_t i = 0; i < box->triangles.size(); ++i) {
    const mesh::Facet f = mesh::facet(*box, box->triangles[i]);
    if (std::abs(mesh::area_vector(f).z) > 0) continue;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(box->corners.texture[i][corner][1], f[corner].z > 0 ? 1 : 0) << "v is up";
    }
  }
}

TEST(DrawnShape, DrawsAllOutlinesOfAGeometry) {
  const auto outline = [](double half) {
    const std::string h = std::to_string(half);
    return "<polyline><point>-" + h + " -" + h + "</point><point>" + h + " -" + h +
           "</point><point>" + h + ' ' + h + "</point><point>-" + h + ' ' + h +
           "</point><height>2</height></polyline>";
  };
  const Drawing drawing = drawn_sdf(visual_of(outline(3) + outline(1)), {Layer::kVisual});
  ASSERT_EQ(drawing.bodies.size(), 1U);
  EXPECT_NEAR(moments_of(*drawing.bodies[0].mesh, {1, 1, 1}).volume, (36 - 4) * 2, 1e-9);
}

TEST(DrawnShape, RaisesATerrainAsItsPictureSays) {
  Picture heights{.width = 3, .height = 3, .pixels = std::vector<Pixel>(9)};
  heights.at(0, 0) = {200, 200, 200, 255};  // the upper left: -x, +y
  heights.at(2, 1) = {50, 50, 50, 255};
  const auto terrain = terrain_mesh(heights, {20, 10, 4});
  ASSERT_TRUE(terrain);
  ASSERT_EQ(terrain->positions.size(), 9U);
  EXPECT_EQ(terrain->triangles.size(), 8U);
  int found = 0;
  for (const Vector3& p : terrain->positions) {
    if (p == Vector3{-10, 5, 4} || p == Vector3{10, 0, 1}) {
      ++found;
    } else {
      EXPECT_EQ(p.z, 0);
    }
  }
  EXPECT_EQ(found, 2);
  for (const mesh::Triangle& t : terrain->triangles) {
    EXPECT_GT(mesh::area_vector(mesh::facet(*terrain, t)).z, 0) << "seen from above";
  }
  EXPECT_FALSE(terrain_mesh({.width = 9, .height = 9}, {1, 1, 1}))
      << "a picture without its pixels";
}

TEST(DrawnShape, ThinsOutALargeTerrain) {
  Picture heights{.width = 2049, .height = 600, .pixels = std::vector<Pixel>(2049 * 600)};
  const auto terrain = terrain_mesh(heights, {1, 1, 1});
  ASSERT_TRUE(terrain);
  EXPECT_EQ(terrain->positions.size(), kMaxHeights * kMaxHeights);
  EXPECT_EQ(mesh::bounds_of(terrain->positions).max, (Vector3{0.5, 0.5, 0}));
}

}  // namespace
}  // namespace rigor::view
