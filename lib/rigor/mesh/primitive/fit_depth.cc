// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The depth below a convex surface is a concave function: over a triangle it is nowhere above its
// tangent plane at the middle. So a triangle whose tangent plane stays below the best known is done
// with; the others are cut in four.

#include <rigor/mesh/primitive/fit_depth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rigor::mesh {
namespace {

/// Triangles are cut so often at most, which takes a tenth of a second; then what was found counts.
constexpr std::uint64_t kMaxCuts = 300'000;

struct Depth {
  double value;
  Vector3 slope;  ///< a unit vector, or zero
};

Depth below_round(double radius, const Vector3& off) {
  const double distance = length(off);
  return {radius - distance, distance > 0 ? (-1 / distance) * off : Vector3{}};
}

Depth below_face(double half, double at, const Vector3& axis) {
  return {half - std::abs(at), at > 0 ? -1.0 * axis : axis};
}

const Depth& lesser(const Depth& a, const Depth& b) { return b.value < a.value ? b : a; }

/// Of a point in the primitive's frame.
struct DepthAt {
  Vector3 p;

  Depth operator()(const Box& box) const {
    const Depth x = below_face(box.size.x / 2, p.x, {1, 0, 0});
    const Depth y = below_face(box.size.y / 2, p.y, {0, 1, 0});
    const Depth z = below_face(box.size.z / 2, p.z, {0, 0, 1});
    return lesser(lesser(x, y), z);
  }
  Depth operator()(const Sphere& sphere) const { return below_round(sphere.radius, p); }
  Depth operator()(const Cylinder& cylinder) const {
    return lesser(below_round(cylinder.radius, {p.x, p.y, 0}),
                  below_face(cylinder.length / 2, p.z, {0, 0, 1}));
  }
  Depth operator()(const Capsule& capsule) const {
    const double half = capsule.length / 2;
    return below_round(capsule.radius, {p.x, p.y, p.z - std::clamp(p.z, -half, half)});
  }
};

double size_of(const Primitive& primitive) { return std::cbrt(volume_of(primitive)); }

std::array<Facet, 4> quarters(const Facet& f) {
  const Vector3 a = 0.5 * (f[1] + f[2]);
  const Vector3 b = 0.5 * (f[2] + f[0]);
  const Vector3 c = 0.5 * (f[0] + f[1]);
  return {Facet{f[0], c, b}, Facet{c, f[1], a}, Facet{b, a, f[2]}, Facet{a, b, c}};
}

}  // namespace

double deepest(const TriangleMesh& mesh, const Primitive& primitive, const model::Pose& X_MP) {
  const auto depth = [&primitive](const Vector3& p) { return std::visit(DepthAt{p}, primitive); };
  const model::Pose X_PM = inverse(X_MP);
  const double tolerance = kDepthTolerance * size_of(primitive);
  double best = 0;
  std::uint64_t cuts = 0;
  std::vector<Facet> open;
  for (const Triangle& t : mesh.triangles) {
    const Facet f = facet(mesh, t);
    open.push_back({transform(X_PM, f[0]), transform(X_PM, f[1]), transform(X_PM, f[2])});
    for (const Vector3& corner : open.back()) best = std::max(best, depth(corner).value);
    while (!open.empty()) {
      const Facet piece = open.back();
      open.pop_back();
      const Vector3 middle = (1.0 / 3) * (piece[0] + piece[1] + piece[2]);
      const Depth at = depth(middle);
      best = std::max(best, at.value);
      double highest = at.value;
      for (const Vector3& p : piece)
        highest = std::max(highest, at.value + dot(at.slope, p - middle));
      if (highest <= best + tolerance || cuts >= kMaxCuts) continue;
      ++cuts;
      const auto parts = quarters(piece);
      open.insert(open.end(), parts.begin(), parts.end());
    }
  }
  return best;
}

}  // namespace rigor::mesh
