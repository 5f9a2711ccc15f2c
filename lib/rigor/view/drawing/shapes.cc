// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include <rigor/mesh/normals.h>
#include <rigor/mesh/primitive/primitive_mesh.h>

namespace rigor::view {
namespace {

using mesh::TriangleMesh;
using model::Vector3;
using std::numbers::pi;

/// Edges of a 64-gon turn by 5.6°, those between a side and an end by more than 45°.
constexpr double kCrease = pi / 6;

using TexturePoint = mesh::Corners::Texture;

/// Adds a quadrilateral that shows a picture upright: its corners from the lower left, against the clock.
void add_pictured_quad(TriangleMesh& mesh, const std::array<Vector3, 4>& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
  const TexturePoint a{0, 0};
  const TexturePoint b{1, 0};
  const TexturePoint c{1, 1};
  const TexturePoint d{0, 1};
  mesh.corners.texture.push_back({a, b, c});
  mesh.corners.texture.push_back({a, c, d});
}

TriangleMesh as_one_part(TriangleMesh mesh, std::string name) {
  mesh.parts = {{std::move(name), {}, 0, mesh.triangles.size()}};
  return mesh;
}

/// With a picture on each face, as the simulators put it there.
TriangleMesh unit_box_mesh() {
  constexpr double h = 0.5;
  TriangleMesh mesh;
  add_pictured_quad(mesh, {{{h, -h, -h}, {h, h, -h}, {h, h, h}, {h, -h, h}}});
  add_pictured_quad(mesh, {{{-h, h, -h}, {-h, -h, -h}, {-h, -h, h}, {-h, h, h}}});
  add_pictured_quad(mesh, {{{h, h, -h}, {-h, h, -h}, {-h, h, h}, {h, h, h}}});
  add_pictured_quad(mesh, {{{-h, -h, -h}, {h, -h, -h}, {h, -h, h}, {-h, -h, h}}});
  add_pictured_quad(mesh, {{{-h, -h, h}, {h, -h, h}, {h, h, h}, {-h, h, h}}});
  add_pictured_quad(mesh, {{{-h, h, -h}, {h, h, -h}, {h, -h, -h}, {-h, -h, -h}}});
  return as_one_part(std::move(mesh), "box");
}

TriangleMesh unit_square_mesh() {
  constexpr double h = 0.5;
  TriangleMesh mesh;
  add_pictured_quad(mesh, {{{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}}});
  return as_one_part(std::move(mesh), "plane");
}

/// A hundredth of an atom. The squares of much smaller sizes are no numbers any more to Embree.
constexpr double kThinnestShape = 1e-12;  // m

bool is_length(double value) { return std::isfinite(value) && value >= kThinnestShape; }

constexpr const char* kBadSize = "a size is not positive and finite, or thinner than 1e-12 m";

}  // namespace

std::shared_ptr<const mesh::TriangleMesh> ShapeMeshes::unit(Unit which) {
  auto& known = units_[which];
  if (known) return known;
  TriangleMesh mesh;
  switch (which) {
    case Unit::kBox: mesh = unit_box_mesh(); break;
    case Unit::kBall: mesh = mesh::mesh_of(mesh::Sphere{.radius = 1}); break;
    case Unit::kCylinder: mesh = mesh::mesh_of(mesh::Cylinder{.radius = 1, .length = 1}); break;
    case Unit::kCone: mesh = mesh::cone_mesh(1, 1); break;
    case Unit::kSquare: mesh = unit_square_mesh(); break;
  }
  if (which != Unit::kBox && which != Unit::kSquare) {
    mesh = mesh::recomputed_normals(std::move(mesh), kCrease);
  }
  known = std::make_shared<const TriangleMesh>(std::move(mesh));
  return known;
}

std::shared_ptr<const mesh::TriangleMesh> ShapeMeshes::square() { return unit(Unit::kSquare); }

ShapeMesh ShapeMeshes::capsule(double radius, double length) {
  const double slenderness = length / radius;
  if (!std::isfinite(slenderness)) return {.why = kBadSize};
  if (capsules_.size() >= kMaxCapsules && !capsules_.contains(slenderness)) {
    return {.why = "more than " + std::to_string(kMaxCapsules) + " capsules are not drawn"};
  }
  auto& known = capsules_[slenderness];
  if (!known) {
    TriangleMesh mesh = mesh::mesh_of(mesh::Capsule{.radius = 1, .length = slenderness});
    known =
        std::make_shared<const TriangleMesh>(mesh::recomputed_normals(std::move(mesh), kCrease));
  }
  return {.mesh = known, .scale = {radius, radius, radius}};
}

struct ShapeMeshVisitor {
  ShapeMeshes& meshes;
  using Unit = ShapeMeshes::Unit;

  ShapeMesh scaled(Unit which, const Vector3& scale) const {
    if (!is_length(scale.x) || !is_length(scale.y) || !is_length(scale.z)) return {.why = kBadSize};
    return {.mesh = meshes.unit(which), .scale = scale};
  }
  /// Sheets without a thickness are drawn in many models.
  ShapeMesh operator()(const model::Box& box) const {
    const Vector3& s = box.size.value;
    const int flat = (s.x == 0 ? 1 : 0) + (s.y == 0 ? 1 : 0) + (s.z == 0 ? 1 : 0);
    if (flat != 1) return scaled(Unit::kBox, s);
    if (!std::isfinite(s.x + s.y + s.z) || std::min({s.x, s.y, s.z}) < 0) return {.why = kBadSize};
    return {.mesh = meshes.unit(Unit::kBox), .scale = s};
  }
  ShapeMesh operator()(const model::Sphere& sphere) const {
    const double r = sphere.radius.value;
    return scaled(Unit::kBall, {r, r, r});
  }
  ShapeMesh operator()(const model::Ellipsoid& ellipsoid) const {
    return scaled(Unit::kBall, ellipsoid.radii.value);
  }
  ShapeMesh operator()(const model::Cylinder& cylinder) const {
    const double r = cylinder.radius.value;
    return scaled(Unit::kCylinder, {r, r, cylinder.length.value});
  }
  ShapeMesh operator()(const model::Cone& cone) const {
    const double r = cone.radius.value;
    return scaled(Unit::kCone, {r, r, cone.length.value});
  }
  ShapeMesh operator()(const model::Capsule& capsule) const {
    const double r = capsule.radius.value;
    const double length = capsule.length.value;
    if (!is_length(r) || !std::isfinite(length) || length < 0) return {.why = kBadSize};
    return meshes.capsule(r, length);
  }
  ShapeMesh operator()(const model::NoShape&) const { return {.why = "it has no shape"}; }
  ShapeMesh operator()(const model::Image&) const {
    return {.why = "an image is no shape that is drawn"};
  }
  template <class Other>
  ShapeMesh operator()(const Other&) const {
    return {.why = "it is no primitive"};
  }
};

ShapeMesh ShapeMeshes::of(const model::Shape& shape) {
  return std::visit(ShapeMeshVisitor{*this}, shape);
}

}  // namespace rigor::view
