// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The hull: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information
// Processing Letters 9 (1979).

#include <rigor/simulate/footprint.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <rigor/simulate/reach.h>

namespace rigor::simulate {
namespace {

double turn_at(const Vector3& a, const Vector3& b, const Vector3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Adds to one chain of the hull what makes it turn left only.
void chain_on(std::vector<Vector3>& hull, std::size_t least, const Vector3& p) {
  while (hull.size() > least && turn_at(hull[hull.size() - 2], hull.back(), p) <= 0) {
    hull.pop_back();
  }
  hull.push_back(p);
}

Vector3 outward_of(const Vector3& a, const Vector3& b) {
  const Vector3 side = b - a;
  const double size = std::hypot(side.x, side.y);
  return {side.y / size, -side.x / size, 0};
}

/// Half of its extent along a level unit vector.
double half_width_along(const std::vector<Vector3>& corners, const Vector3& direction) {
  double least = kInfinity;
  double most = -kInfinity;
  for (const Vector3& corner : corners) {
    least = std::min(least, dot(corner, direction));
    most = std::max(most, dot(corner, direction));
  }
  return (most - least) / 2;
}

bool is_thin(const std::vector<Vector3>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3 across = outward_of(corners[i], corners[(i + 1) % corners.size()]);
    if (2 * half_width_along(corners, across) < kThinFootprint) return true;
  }
  return false;
}

}  // namespace

std::vector<Vector3> footprint(std::vector<Vector3> points) {
  const auto key = [](const Vector3& p) { return std::tie(p.x, p.y); };
  std::stable_sort(points.begin(), points.end(),
                   [&](const Vector3& a, const Vector3& b) { return key(a) < key(b); });
  points.erase(std::unique(points.begin(), points.end(),
                           [&](const Vector3& a, const Vector3& b) { return key(a) == key(b); }),
               points.end());
  if (points.size() < 3) return points;
  std::vector<Vector3> hull;
  for (const Vector3& p : points) chain_on(hull, 1, p);
  const std::size_t lower = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) chain_on(hull, lower, points[i]);
  hull.pop_back();
  if (hull.size() < 3 || is_thin(hull)) return {points.front(), points.back()};
  return hull;
}

FootprintMargin margin_in(const std::vector<Vector3>& corners, const Vector3& point) {
  FootprintMargin nearest{.distance = kInfinity};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3& a = corners[i];
    const Vector3 outward = outward_of(a, corners[(i + 1) % corners.size()]);
    const double distance = dot(a - point, outward);
    if (distance < nearest.distance) nearest = {distance, 0, outward};
  }
  nearest.half_width = half_width_along(corners, nearest.outward);
  return nearest;
}

std::vector<Vector3> footprint_at_start(const Scene& scene, std::uint32_t model, double slack) {
  const auto of_model = [&](const SceneShape& shape) {
    return shape.body < scene.bodies.size() && scene.bodies[shape.body].model == model;
  };
  double lowest = kInfinity;
  for (const SceneShape& shape : scene.shapes) {
    if (of_model(shape)) lowest = std::min(lowest, -reach(scene, shape, {0, 0, -1}));
  }
  std::vector<Vector3> points;
  for (const SceneShape& shape : scene.shapes) {
    if (!of_model(shape)) continue;
    const std::vector<Vector3> low = low_points(scene, shape, lowest + slack);
    points.insert(points.end(), low.begin(), low.end());
  }
  return footprint(std::move(points));
}

TiltOver tip_angle(const Scene& scene, std::uint32_t model, const std::vector<Vector3>& corners) {
  const Vector3 center = center_of_mass(scene, model);
  const FootprintMargin margin = margin_in(corners, center);
  double ground = kInfinity;
  for (const Vector3& corner : corners) ground = std::min(ground, corner.z);
  return {std::atan2(margin.distance, center.z - ground), margin.outward};
}

Vector3 center_of_mass(const Scene& scene, std::uint32_t model) {
  Vector3 sum;
  double mass = 0;
  for (const SceneBody& body : scene.bodies) {
    if (body.model != model) continue;
    sum = sum + body.mass.mass * transform(body.X_WB, body.mass.com);
    mass += body.mass.mass;
  }
  return mass > 0 ? (1 / mass) * sum : sum;
}

}  // namespace rigor::simulate
