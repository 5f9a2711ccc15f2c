// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/round_shape.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <rigor/simulate/reach.h>

namespace rigor::simulate {
namespace {

/// Cosine of the angle between a cylinder's axis and its joint's up to which it is still meant to
/// roll: 25°. Such a wheel wobbles, but that is for others to say.
constexpr double kRollingCosine = 0.9;

/// A mesh is round when it reaches in all directions across the axis this share of what it reaches in
/// the farthest: a hexagon has 0.866, a square 0.707.
constexpr double kRoundShare = 0.85;
constexpr int kRimDirections =
    61;  // a prime: corners of no regular outline are met more often than sides

/// Vertices that are as far from the axis as this share of the radius belong to the rim.
constexpr double kRimShare = 0.9;

std::optional<RoundShape> along_own_axis(const Pose& X_WS, double radius, double width,
                                         const Vector3& axis_W) {
  const Vector3 own = rotate(X_WS.rotation, {0, 0, 1});
  if (std::abs(dot(own, axis_W)) < kRollingCosine) return std::nullopt;
  return RoundShape{radius, width, X_WS.translation, own};
}

Vector3 any_across(const Vector3& axis) {
  const Vector3 other = std::abs(axis.z) < 0.9 ? Vector3{0, 0, 1} : Vector3{1, 0, 0};
  const Vector3 across = cross(axis, other);
  return (1 / length(across)) * across;
}

struct RimExtent {
  double least = kInfinity;
  double most = -kInfinity;
  double middle() const { return (least + most) / 2; }
  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

/// A mesh as a disk about the middle of its bounds across the axis.
std::optional<RoundShape> round_mesh(const std::vector<Vector3>& points, const Pose& X_WS,
                                     const Vector3& axis_W) {
  const Vector3 axis = rotate(conjugate(X_WS.rotation), axis_W);
  const Vector3 u = any_across(axis);
  const Vector3 v = cross(axis, u);
  RimExtent along_u, along_v;
  for (const Vector3& p : points) {
    along_u.add(dot(p, u));
    along_v.add(dot(p, v));
  }
  const Vector3 center = along_u.middle() * u + along_v.middle() * v;
  RimExtent rim;
  double sum = 0;
  for (int i = 0; i < kRimDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRimDirections;
    const Vector3 outward = std::cos(angle) * u + std::sin(angle) * v;
    double farthest = 0;
    for (const Vector3& p : points) farthest = std::max(farthest, dot(p - center, outward));
    rim.add(farthest);
    sum += farthest;
  }
  if (!(rim.most > 0) || rim.least < kRoundShare * rim.most) return std::nullopt;
  // Cauchy: the mean over all directions is the convex outline's length over 2 pi, and that length is
  // how far it rolls in a turn.
  const double radius = sum / kRimDirections;
  RimExtent width;
  for (const Vector3& p : points) {
    const Vector3 out = p - center;
    if (std::hypot(dot(out, u), dot(out, v)) >= kRimShare * radius) width.add(dot(p, axis));
  }
  const Vector3 middle = center + width.middle() * axis;
  return RoundShape{radius, width.most - width.least, transform(X_WS, middle), axis_W};
}

}  // namespace

std::optional<RoundShape> round_about(const Scene& scene, const SceneShape& shape,
                                      const Vector3& axis_W) {
  const Pose X_WS = start_pose(scene, shape);
  if (const auto* sphere = std::get_if<mesh::Sphere>(&shape.kind)) {
    return RoundShape{sphere->radius, 0, X_WS.translation, {}};
  }
  if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape.kind)) {
    return along_own_axis(X_WS, cylinder->radius, cylinder->length, axis_W);
  }
  if (const auto* capsule = std::get_if<mesh::Capsule>(&shape.kind)) {
    return along_own_axis(X_WS, capsule->radius, capsule->length, axis_W);
  }
  if (const auto* hull = std::get_if<ConvexHull>(&shape.kind)) {
    return round_mesh(scene.meshes[hull->mesh].positions, X_WS, axis_W);
  }
  if (const auto* soup = std::get_if<TriangleSoup>(&shape.kind)) {
    return round_mesh(scene.meshes[soup->mesh].positions, X_WS, axis_W);
  }
  return std::nullopt;
}

}  // namespace rigor::simulate
