// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/primitive/primitive_mesh.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace rigor::mesh {
namespace {

using std::numbers::pi;

struct VolumeOf {
  double operator()(const Box& b) const { return b.size.x * b.size.y * b.size.z; }
  double operator()(const Sphere& s) const { return 4.0 / 3 * pi * s.radius * s.radius * s.radius; }
  double operator()(const Cylinder& c) const { return pi * c.radius * c.radius * c.length; }
  double operator()(const Capsule& c) const {
    return (*this)(Cylinder{c.radius, c.length}) + (*this)(Sphere{c.radius});
  }
};

struct LatheRing {
  double radius;
  double z;
};

/// The rings turned about z, from a pole at `top` down to one at `bottom`.
TriangleMesh turned_on_lathe(double top, const std::vector<LatheRing>& rings, double bottom) {
  constexpr std::uint32_t n = kCircleSegments;
  TriangleMesh mesh;
  for (const LatheRing& ring : rings) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * pi * i / n;
      mesh.positions.push_back(
          {ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.z});
    }
  }
  const auto north = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back({0, 0, top});
  mesh.positions.push_back({0, 0, bottom});
  const std::uint32_t last = north - n;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({north, i, next});
    for (std::uint32_t ring = 0; ring < last; ring += n) {
      mesh.triangles.push_back({ring + i, ring + n + i, ring + n + next});
      mesh.triangles.push_back({ring + i, ring + n + next, ring + next});
    }
    mesh.triangles.push_back({north + 1, last + next, last + i});
  }
  return mesh;
}

/// Two half balls, their centers `length` apart; the equator is drawn once when that is zero.
TriangleMesh round_ended(double radius, double length) {
  constexpr unsigned quarter = kCircleSegments / 4;
  std::vector<LatheRing> rings;
  for (unsigned i = 1; i <= quarter; ++i) {
    const double angle = pi / 2 * i / quarter;
    rings.push_back({radius * std::sin(angle), length / 2 + radius * std::cos(angle)});
  }
  rings.back() = {radius, length / 2};
  for (unsigned i = length > 0 ? quarter : quarter - 1; i > 0; --i) {
    rings.push_back({rings[i - 1].radius, -rings[i - 1].z});
  }
  return turned_on_lathe(length / 2 + radius, rings, -length / 2 - radius);
}

struct MeshOf {
  TriangleMesh operator()(const Box& box) const {
    TriangleMesh mesh;
    for (unsigned i = 0; i < 8; ++i) {
      mesh.positions.push_back({((i & 1U) != 0 ? 0.5 : -0.5) * box.size.x,
                                ((i & 2U) != 0 ? 0.5 : -0.5) * box.size.y,
                                ((i & 4U) != 0 ? 0.5 : -0.5) * box.size.z});
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
  }
  TriangleMesh operator()(const Sphere& s) const { return round_ended(s.radius, 0); }
  TriangleMesh operator()(const Cylinder& c) const {
    return turned_on_lathe(c.length / 2, {{c.radius, c.length / 2}, {c.radius, -c.length / 2}},
                           -c.length / 2);
  }
  TriangleMesh operator()(const Capsule& c) const { return round_ended(c.radius, c.length); }
};

struct NameOf {
  const char* operator()(const Box&) const { return "box"; }
  const char* operator()(const Sphere&) const { return "sphere"; }
  const char* operator()(const Cylinder&) const { return "cylinder"; }
  const char* operator()(const Capsule&) const { return "capsule"; }
};

}  // namespace

double volume_of(const Primitive& primitive) { return std::visit(VolumeOf{}, primitive); }

TriangleMesh mesh_of(const Primitive& primitive) {
  TriangleMesh mesh = std::visit(MeshOf{}, primitive);
  mesh.parts = {{std::visit(NameOf{}, primitive), {}, 0, mesh.triangles.size()}};
  return mesh;
}

TriangleMesh cone_mesh(double radius, double length) {
  TriangleMesh mesh = turned_on_lathe(length / 2, {{radius, -length / 2}}, -length / 2);
  mesh.parts = {{"cone", {}, 0, mesh.triangles.size()}};
  return mesh;
}

}  // namespace rigor::mesh
