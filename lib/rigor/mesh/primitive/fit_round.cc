// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <rigor/mesh/primitive/fit_axis.h>
#include <rigor/mesh/primitive/fit_ball.h>

namespace rigor::mesh {
namespace {

/// The points seen along the axis: the smallest circle around them, and where they are along it.
struct Shadow {
  Basis basis;
  std::vector<Vector3> flat;  // z is zero
  std::vector<double> along;
  Ball circle;
};

/// An axis and its opposite are one: z points up, or else y or x.
Vector3 upward(const Vector3& axis) {
  const double lead = axis.z != 0 ? axis.z : axis.y != 0 ? axis.y : axis.x;
  return lead < 0 ? -1.0 * axis : axis;
}

Shadow shadow_along(const Vector3& axis, const std::vector<Vector3>& points) {
  Shadow shadow{basis_about(axis), {}, {}, {}};
  shadow.flat.reserve(points.size());
  shadow.along.reserve(points.size());
  for (const Vector3& p : points) {
    shadow.flat.push_back({dot(p, shadow.basis[0]), dot(p, shadow.basis[1]), 0});
    shadow.along.push_back(dot(p, axis));
  }
  shadow.circle = enclosing_ball(shadow.flat);
  return shadow;
}

/// Turned by the shortest way from z to the axis, which does not point down.
Placed placed(const Primitive& shape, const Shadow& shadow, double middle) {
  const Basis& b = shadow.basis;
  const Vector3& c = shadow.circle.center;
  const Vector3 center = c.x * b[0] + c.y * b[1] + middle * b[2];
  return {shape,
          {center, normalized(model::Quaternion{1 + b[2].z, -b[2].y, b[2].x, 0})},
          volume_of(shape)};
}

}  // namespace

Placed cylinder_along(const Vector3& axis, const std::vector<Vector3>& points) {
  const Shadow shadow = shadow_along(upward(axis), points);
  const auto [low, high] = std::minmax_element(shadow.along.begin(), shadow.along.end());
  return placed(Cylinder{shadow.circle.radius, *high - *low}, shadow, 0.5 * (*low + *high));
}

Placed capsule_along(const Vector3& axis, const std::vector<Vector3>& points) {
  const Shadow shadow = shadow_along(upward(axis), points);
  const double radius = shadow.circle.radius;
  // The centers of the caps: a cap reaches a point that is off the axis from so far below it.
  double top = -std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double off = length(shadow.flat[i] - shadow.circle.center);
    const double reach = std::sqrt(std::max(0.0, (radius - off) * (radius + off)));
    top = std::max(top, shadow.along[i] - reach);
    bottom = std::min(bottom, shadow.along[i] + reach);
  }
  return placed(Capsule{radius, std::max(0.0, top - bottom)}, shadow, 0.5 * (top + bottom));
}

}  // namespace rigor::mesh
