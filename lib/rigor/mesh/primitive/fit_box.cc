// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <rigor/mesh/primitive/fit_axis.h>
#include <rigor/mesh/spatial/plane_point.h>

namespace rigor::mesh {
namespace {

using model::Quaternion;

/// Of the rotation whose matrix has these columns (K. Shoemake, "Animating rotation with quaternion
/// curves", 1985), when its trace is not negative.
Quaternion rotation_to(const Basis& c) {
  const double w = 0.5 * std::sqrt(std::max(0.0, 1 + c[0].x + c[1].y + c[2].z));
  const double f = 0.25 / w;
  return normalized(
      Quaternion{w, f * (c[1].z - c[2].y), f * (c[2].x - c[0].z), f * (c[0].y - c[1].x)});
}

/// The same box has 24 orientations; this is the one that is turned least: by no more than 63°, so
/// that its trace is far from negative.
Basis least_turned(const Basis& d) {
  constexpr std::array<std::array<std::size_t, 3>, 6> kOrders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
  const auto turned = [](const Vector3& v, double sign) { return (sign < 0 ? -1.0 : 1.0) * v; };
  Basis best = d;
  double best_trace = -std::numeric_limits<double>::infinity();
  for (const auto& order : kOrders) {
    Basis b = {turned(d[order[0]], d[order[0]].x), turned(d[order[1]], d[order[1]].y),
               turned(d[order[2]], d[order[2]].z)};
    if (dot(b[0], cross(b[1], b[2])) < 0) {
      const std::array<double, 3> diagonal = {b[0].x, b[1].y, b[2].z};
      const auto least = std::min_element(diagonal.begin(), diagonal.end()) - diagonal.begin();
      Vector3& v = b[static_cast<std::size_t>(least)];
      v = -1.0 * v;
    }
    const double trace = b[0].x + b[1].y + b[2].z;
    if (trace > best_trace) {
      best_trace = trace;
      best = b;
    }
  }
  return best;
}

/// Counter-clockwise, without points on its edges (A. M. Andrew's monotone chain, 1979).
std::vector<PlanePoint> outline(std::vector<PlanePoint> points) {
  std::sort(points.begin(), points.end(), [](const PlanePoint& a, const PlanePoint& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  std::vector<PlanePoint> chain;
  const auto add = [&chain](const PlanePoint& p, std::size_t keep) {
    while (chain.size() >= keep + 2 &&
           cross(chain.back() - chain[chain.size() - 2], p - chain.back()) <= 0) {
      chain.pop_back();
    }
    chain.push_back(p);
  };
  for (const PlanePoint& p : points) add(p, 0);
  const std::size_t half = chain.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, half);
  chain.pop_back();
  return chain;
}

/// Along a side of the smallest rectangle, one of which lies on an edge of the outline (H. Freeman,
/// R. Shapira, 1975; rotating calipers: G. Toussaint, 1983). Not a unit vector.
PlanePoint smallest_rectangle(const std::vector<PlanePoint>& outline) {
  const std::size_t n = outline.size();
  const auto at = [&outline, n](std::size_t i) { return outline[i % n]; };
  // Steps on while that leads farther, and never round more than once.
  const auto advance = [&at, n](std::size_t from, const PlanePoint& along) {
    const std::size_t end = from + n;
    while (from < end && dot(at(from + 1) - at(from), along) > 0) ++from;
    return from;
  };
  PlanePoint best{1, 0};
  double least = std::numeric_limits<double>::infinity();
  std::size_t right = 0;
  std::size_t top = 0;
  std::size_t left = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const PlanePoint d = at(i + 1) - at(i);
    const PlanePoint up{-d.y, d.x};
    right = advance(std::max(right, i + 1), d);
    top = advance(std::max(top, right), up);
    left = advance(std::max(left, top), {-d.x, -d.y});
    const double area = dot(at(right) - at(left), d) * dot(at(top) - at(i), up) / dot(d, d);
    if (area < least) {
      least = area;
      best = d;
    }
  }
  return best;
}

}  // namespace

Placed box_along(const Basis& directions, const std::vector<Vector3>& points) {
  const Basis axes = least_turned(directions);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Bounds bounds{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  for (const Vector3& p : points) {
    const Vector3 q{dot(p, axes[0]), dot(p, axes[1]), dot(p, axes[2])};
    bounds.min = {std::min(bounds.min.x, q.x), std::min(bounds.min.y, q.y),
                  std::min(bounds.min.z, q.z)};
    bounds.max = {std::max(bounds.max.x, q.x), std::max(bounds.max.y, q.y),
                  std::max(bounds.max.z, q.z)};
  }
  const Vector3 middle = 0.5 * (bounds.min + bounds.max);
  const Box box{bounds.max - bounds.min};
  const Vector3 center = middle.x * axes[0] + middle.y * axes[1] + middle.z * axes[2];
  return {box, {center, rotation_to(axes)}, volume_of(box)};
}

Placed box_about(const Vector3& axis, const std::vector<Vector3>& points) {
  const Basis basis = basis_about(axis);
  std::vector<PlanePoint> shadow;
  shadow.reserve(points.size());
  for (const Vector3& p : points) shadow.push_back({dot(p, basis[0]), dot(p, basis[1])});
  const PlanePoint side = smallest_rectangle(outline(std::move(shadow)));
  const double size = std::hypot(side.x, side.y);
  if (!(size > 0)) return box_along(basis, points);
  const Vector3 u = (side.x / size) * basis[0] + (side.y / size) * basis[1];
  return box_along({u, cross(axis, u), axis}, points);
}

}  // namespace rigor::mesh
