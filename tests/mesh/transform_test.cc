// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Transforms against cases done by hand, properties, and the same sums in a wider type.

#include <rigor/mesh/transform.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mass/polyhedron.h>
#include <rigor/mesh/normals.h>
#include <rigor/mesh/stl/stl.h>
#include <rigor/mesh/write/write.h>

#include "support/meshes.h"

namespace rigor::mesh {
namespace {

using test::box_mesh;

TriangleMesh lone_triangle() {
  return {.positions = {{1, 2, 3}, {4, 2, 3}, {1, 8, 5}},
          .triangles = {{0, 1, 2}},
          .parts = {{"tip", "steel", 0, 1}}};
}

std::array<double, 3> xyz(const Vector3& p) { return {p.x, p.y, p.z}; }

// ---- By hand

TEST(Transform, NothingAskedChangesNothing) {
  const TriangleMesh mesh = lone_triangle();
  const Transformed result = transformed(mesh, {});
  EXPECT_EQ(result.mesh.positions, mesh.positions);
  EXPECT_EQ(result.mesh.triangles, mesh.triangles);
  EXPECT_EQ(result.mesh.parts[0].name, "tip");
  EXPECT_EQ(result.translation, Vector3{});
}

TEST(Transform, UnitAndScaleMultiply) {
  const Transformed result = transformed(lone_triangle(), {.unit = 0.5, .scale = {2, 4, -8}});
  EXPECT_EQ(result.mesh.positions, (std::vector<Vector3>{{1, 4, -12}, {4, 4, -12}, {1, 16, -20}}));
}

/// Scale acts along the axes that the mesh has before it is turned.
TEST(Transform, TurnsYUpAfterScaling) {
  const Transformed result =
      transformed(lone_triangle(), {.scale = {1, 10, 100}, .up = UpAxis::kY});
  EXPECT_EQ(result.mesh.positions,
            (std::vector<Vector3>{{1, -300, 20}, {4, -300, 20}, {1, -500, 80}}));
  EXPECT_EQ(result.mesh.triangles, lone_triangle().triangles);  // a turn, no mirror
  EXPECT_FALSE(std::signbit(before_centering({.up = UpAxis::kY}, {1, 1, 0}).y));
}

TEST(Transform, CentersAtAPointOfTheGivenMesh) {
  const Transform by{.unit = 0.5, .up = UpAxis::kY, .center = Center::kPoint, .point = {1, 2, 4}};
  const Transformed result = transformed(lone_triangle(), by);
  EXPECT_EQ(result.translation, (Vector3{-0.5, 2, -1}));
  EXPECT_EQ(result.mesh.positions,
            (std::vector<Vector3>{{0, 0.5, 0}, {1.5, 0.5, 0}, {0, -0.5, 3}}));
}

TEST(Transform, CentersTheBoundsOrTheirBottom) {
  const TriangleMesh box = box_mesh({2, 4, 6}, {10, 20, 30});
  const Transformed middle = transformed(box, {.center = Center::kBounds});
  EXPECT_EQ(middle.translation, (Vector3{-10, -20, -30}));
  EXPECT_EQ(middle.mesh.positions, box_mesh({2, 4, 6}).positions);
  const Transformed bottom = transformed(box, {.center = Center::kBottom});
  EXPECT_EQ(bottom.translation, (Vector3{-10, -20, -27}));
  EXPECT_EQ(bottom.mesh.positions, box_mesh({2, 4, 6}, {0, 0, 3}).positions);
}

TEST(Transform, CentersOnlyWhatTrianglesUse) {
  TriangleMesh mesh = box_mesh({2, 2, 2}, {1, 1, 1});
  mesh.positions.push_back({1000, 1000, 1000});
  EXPECT_EQ(transformed(mesh, {.center = Center::kBounds}).translation, (Vector3{-1, -1, -1}));
  const TriangleMesh points{.positions = {{1, 2, 3}}};
  for (const Center center : {Center::kBounds, Center::kBottom, Center::kPoint}) {
    const Transformed result = transformed(points, {.center = center, .point = {1, 1, 1}});
    EXPECT_EQ(result.translation, Vector3{});
    EXPECT_EQ(result.mesh.positions, points.positions);
  }
}

TEST(Transform, MirrorsSwapTheWinding) {
  const auto winding = [](double unit, const Vector3& scale) {
    return transformed(lone_triangle(), {.unit = unit, .scale = scale}).mesh.triangles[0];
  };
  const Triangle kept{0, 1, 2};
  const Triangle swapped{0, 2, 1};
  EXPECT_EQ(winding(1, {1, 1, -1}), swapped);
  EXPECT_EQ(winding(1, {-1, 1, -1}), kept);
  EXPECT_EQ(winding(1, {-1, -1, -1}), swapped);
  EXPECT_EQ(winding(-1, {1, 1, 1}), swapped);
  EXPECT_EQ(winding(1e-200, {-1e-200, 1e-200, 1e-200}), swapped);  // the product is zero
}

// ---- What corners carry

TriangleMesh dressed_triangle() {
  TriangleMesh mesh = lone_triangle();
  mesh.corners.texture = {{{{0, 0}, {1, 0}, {0, 1}}}};
  mesh.corners.colors = {{{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}}}};
  mesh.corners.normals = {{{{0.6F, 0, 0.8F}, {0, 0, 1}, {0, 1, 0}}}};
  return mesh;
}

/// A slope of 3 in 4 along x is one of 3 in 8 when x is doubled, whatever the unit.
TEST(Transform, NormalsStayPerpendicular) {
  const TriangleMesh mesh =
      transformed(dressed_triangle(), {.unit = 0.001, .scale = {2, 1, 1}}).mesh;
  const auto& normals = mesh.corners.normals[0];
  EXPECT_FLOAT_EQ(normals[0][0], 3 / std::sqrt(73.0F));
  EXPECT_FLOAT_EQ(normals[0][2], 8 / std::sqrt(73.0F));
  EXPECT_EQ(normals[1], (Corners::Normal{0, 0, 1}));
  EXPECT_EQ(mesh.corners.texture, dressed_triangle().corners.texture);
  EXPECT_EQ(mesh.corners.colors, dressed_triangle().corners.colors);
}

TEST(Transform, NormalsAreExactWhenNothingIsStretched) {
  const TriangleMesh mesh = dressed_triangle();
  EXPECT_EQ(transformed(mesh, {.unit = 0.0254, .scale = {3, 3, 3}, .center = Center::kBounds})
                .mesh.corners.normals,
            mesh.corners.normals);
  const TriangleMesh turned = transformed(mesh, {.up = UpAxis::kY}).mesh;
  EXPECT_EQ(turned.corners.normals[0],
            (std::array<Corners::Normal, 3>{{{0.6F, -0.8F, 0}, {0, -1, 0}, {0, 0, 1}}}));
  EXPECT_FALSE(std::signbit(turned.corners.normals[0][2][1]));
}

TEST(Transform, MirrorsSwapWhatCornersCarry) {
  const TriangleMesh mesh = transformed(dressed_triangle(), {.scale = {1, 1, -1}}).mesh;
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 2, 1}));
  EXPECT_EQ(mesh.corners.texture[0], (std::array<Corners::Texture, 3>{{{0, 0}, {0, 1}, {1, 0}}}));
  EXPECT_EQ(mesh.corners.colors[0][1], (Corners::Color{0, 0, 1, 1}));
  EXPECT_EQ(mesh.corners.normals[0],
            (std::array<Corners::Normal, 3>{{{0.6F, 0, -0.8F}, {0, 1, 0}, {0, 0, -1}}}));
  const TriangleMesh turned = transformed(dressed_triangle(), {.unit = -1}).mesh;
  EXPECT_EQ(turned.corners.normals[0][0], (Corners::Normal{-0.6F, 0, -0.8F}));
}

// ---- Properties

/// Face normals and corner normals go the same way.
TEST(Transform, FlatNormalsStayThoseOfTheirTriangles) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0.1, 3);
  for (int round = 0; round < 100; ++round) {
    const auto factor = [&] { return random() % 2 == 0 ? any(random) : -any(random); };
    const Transform by{.unit = 0.01,
                       .scale = {factor(), factor(), factor()},
                       .up = random() % 2 == 0 ? UpAxis::kZ : UpAxis::kY};
    TriangleMesh mesh = box_mesh({1, 2, 3});
    for (Vector3& p : mesh.positions) p = p + Vector3{0.1 * p.y * p.z, any(random) / 9, 0};
    const TriangleMesh result = transformed(recomputed_normals(mesh, kFlat), by).mesh;
    for (std::size_t i = 0; i < result.triangles.size(); ++i) {
      const auto [a, b, c] = facet(result, result.triangles[i]);
      const Vector3 out = cross(b - a, c - a);
      const Vector3 normal = as_vector(result.corners.normals[i][0]);
      EXPECT_LE(length(normal - (1 / length(out)) * out), 1e-5);
    }
  }
}

struct Case {
  TriangleMesh mesh;
  Transform by;
};

Case random_case(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  const auto factor = [&] { return std::copysign(std::pow(10, 2 * any(random)), any(random)); };
  const std::array<double, 4> units{1, 0.001, 0.0254, 0.01};
  const Vector3 size{1.5 + any(random), 1.5 + any(random), 1.5 + any(random)};
  TriangleMesh mesh = box_mesh(size, {5 * any(random), 5 * any(random), 5 * any(random)});
  for (Vector3& p : mesh.positions) p = p + Vector3{any(random) / 9, any(random) / 9, 0};
  Transform by{.unit = units[random() % 4],
               .scale = {factor(), factor(), factor()},
               .up = random() % 2 == 0 ? UpAxis::kZ : UpAxis::kY,
               .center = static_cast<Center>(random() % 4),
               .point = {any(random), any(random), any(random)}};
  return {std::move(mesh), by};
}

TEST(Transform, VolumeGrowsByTheDeterminantAndStaysPositive) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const auto [mesh, by] = random_case(random);
    const double before = mass::moments_of(mesh).volume;
    const double after = mass::moments_of(transformed(mesh, by).mesh).volume;
    const double u = by.unit;
    const double determinant = std::abs(u * u * u * by.scale.x * by.scale.y * by.scale.z);
    ASSERT_GT(before, 0);
    EXPECT_NEAR(after / (before * determinant), 1, 1e-12);
  }
}

/// Of the scale's inverse, of the products with both: three roundings of half a unit at most.
TEST(Transform, TheInverseScaleLeadsBack) {
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    const auto [mesh, by] = random_case(random);
    const Transform there{.scale = by.scale};
    const Transform back{.scale = {1 / by.scale.x, 1 / by.scale.y, 1 / by.scale.z}};
    const TriangleMesh again = transformed(transformed(mesh, there).mesh, back).mesh;
    EXPECT_EQ(again.triangles, mesh.triangles);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double was = xyz(mesh.positions[i])[axis];
        const double is = xyz(again.positions[i])[axis];
        EXPECT_NEAR(is, was, 1.5 * std::numeric_limits<double>::epsilon() * std::abs(was));
        EXPECT_LE(std::abs(float{static_cast<float>(is)} - static_cast<float>(was)),
                  std::numeric_limits<float>::epsilon() * std::abs(was));
      }
    }
  }
}

/// The translation takes each vertex to where it is, and its opposite back.
TEST(Transform, TellsTheTranslation) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    const auto [mesh, by] = random_case(random);
    const Transformed result = transformed(mesh, by);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      EXPECT_EQ(result.mesh.positions[i],
                before_centering(by, mesh.positions[i]) + result.translation);
    }
    const Bounds bounds = bounds_of(result.mesh.positions);
    if (by.center == Center::kBottom) {
      EXPECT_EQ(bounds.min.z, 0);
    }
    if (by.center == Center::kPoint) {
      EXPECT_EQ(before_centering(by, by.point) + result.translation, Vector3{});
    }
    if (by.center == Center::kNone) {
      EXPECT_EQ(result.translation, Vector3{});
    }
    if (by.center == Center::kBounds) {
      const double tiny = 1e-15 * (model::length(result.translation) + diagonal(bounds));
      EXPECT_LE(model::length(bounds.min + bounds.max), 2 * tiny);
    }
  }
}

/// One coordinate of what the transform is in real numbers, nearly: long double has 11 bits more
/// than double on the machines that this is tested on, and is no worse on any.
long double exact(const Transform& by, const Vector3& p, const Vector3& translation,
                  std::size_t axis) {
  const auto scaled = [&](std::size_t i) {
    return static_cast<long double>(xyz(p)[i]) * by.unit * xyz(by.scale)[i];
  };
  const bool turned = by.up == UpAxis::kY;
  const long double value = !turned || axis == 0 ? scaled(axis)
                            : axis == 1          ? -scaled(2)
                                                 : scaled(1);
  return value + xyz(translation)[axis];
}

TEST(Transform, AWrittenStlIsWithinOneUnitOfTheExactTransform) {
  std::mt19937 random(4);
  for (int round = 0; round < 300; ++round) {
    const auto [mesh, by] = random_case(random);
    const Transformed result = transformed(mesh, by);
    const std::string bytes = write_stl(result.mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Facet read = stl_facet(bytes.data() + kStlHeaderBytes + kStlFacetBytes * t);
      Triangle corners = mesh.triangles[t];
      if (result.mesh.triangles[t] != corners) std::swap(corners[1], corners[2]);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vector3& p = mesh.positions[corners[corner]];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto wanted = exact(by, p, result.translation, axis);
          const auto size = std::abs(static_cast<double>(wanted));
          // A coordinate that the centering brings to zero is as good as the sum in double.
          const double sum = std::numeric_limits<double>::epsilon() *
                             (size + std::abs(xyz(result.translation)[axis]));
          EXPECT_NEAR(xyz(read[corner])[axis], static_cast<double>(wanted),
                      std::numeric_limits<float>::epsilon() * size + sum);
        }
      }
    }
  }
}

}  // namespace
}  // namespace rigor::mesh
