// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/thinness.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor::mesh {
namespace {

double square(const Vector3& v) { return dot(v, v); }

double largest(const Vector3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

}  // namespace

Thinness thinness(const Facet& facet) {
  const Vector3 u = facet[1] - facet[0];
  const Vector3 v = facet[2] - facet[0];
  const Vector3 normal{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double longest2 = std::max({square(u), square(v), square(facet[2] - facet[1])});
  const double twice_area2 = square(normal);  // (longest * height)²
  if (twice_area2 >= kSliverRatio * kSliverRatio * longest2 * longest2) return Thinness::kNone;
  const double reach = std::max({largest(facet[0]), largest(facet[1]), largest(facet[2])});
  const double rounding = kLineRoundings * std::numeric_limits<double>::epsilon() * reach;
  return twice_area2 <= longest2 * rounding * rounding ? Thinness::kLine : Thinness::kSliver;
}

}  // namespace rigor::mesh
