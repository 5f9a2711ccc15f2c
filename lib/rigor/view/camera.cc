// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/camera.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rigor::view {
namespace {

constexpr std::array<std::pair<View, std::string_view>, 5> kViewNames{{
    {View::kPerspective, "perspective"},
    {View::kFront, "front"},
    {View::kSide, "side"},
    {View::kTop, "top"},
    {View::kBack, "back"},
}};

/// Of half of the picture; the rest is margin.
constexpr double kFilled = 0.92;
/// rad. Narrow enough that a robot's near wheels do not look swollen.
constexpr double kFieldOfView = 0.55;
/// Of the diagonal: nothing is examined as thinner, since a line would be
/// enlarged without end.
constexpr double kThinnest = 1e-3;

/// Towards where the eye is, from what it looks at.
model::Vector3 towards_eye(View view) {
  switch (view) {
    case View::kFront: return {1, 0, 0};
    case View::kSide: return {0, 1, 0};
    case View::kTop: return {0, 0, 1};
    case View::kBack: return {-1, 0, 0};
    case View::kPerspective: break;
  }
  return {1, 0.62, 0.52};
}

model::Vector3 unit(const model::Vector3& v) { return (1 / length(v)) * v; }

bool is_finite(const model::Vector3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// What can be framed: not empty, not endless, not thin.
mesh::Bounds framable(mesh::Bounds bounds) {
  const bool empty = !is_finite(bounds.min) || !is_finite(bounds.max) ||
                     bounds.min.x > bounds.max.x || bounds.min.y > bounds.max.y ||
                     bounds.min.z > bounds.max.z;
  if (empty) return {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
  const double across = length(bounds.max - bounds.min);
  const double least = across > 0 ? kThinnest * across : 1;
  const auto widen = [least](double& low, double& high) {
    const double lacking = least - (high - low);
    if (lacking <= 0) return;
    low -= lacking / 2;
    high += lacking / 2;
  };
  widen(bounds.min.x, bounds.max.x);
  widen(bounds.min.y, bounds.max.y);
  widen(bounds.min.z, bounds.max.z);
  return bounds;
}

std::array<model::Vector3, 8> corners_of(const mesh::Bounds& bounds) {
  std::array<model::Vector3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {(i & 1U) != 0 ? bounds.max.x : bounds.min.x,
                  (i & 2U) != 0 ? bounds.max.y : bounds.min.y,
                  (i & 4U) != 0 ? bounds.max.z : bounds.min.z};
  }
  return corners;
}

/// How the corners, seen from their center, bound the place of the eye along
/// one axis of the picture. A corner `a` to the right and `c` ahead of the
/// center is in the picture of an eye `e` to the right and `d` ahead when |a -
/// e| <= k (c - d).
struct EyeLimits {
  double right = -INFINITY;  ///< e - k d is at least this
  double left = INFINITY;    ///< e + k d is at most this

  double middle() const { return (right + left) / 2; }
  double farthest_ahead(double k) const { return (left - right) / (2 * k); }
};

}  // namespace

std::string_view to_string(View view) {
  for (const auto& [known, name] : kViewNames) {
    if (known == view) return name;
  }
  return {};
}

std::optional<View> view_named(std::string_view name) {
  for (const auto& [view, known] : kViewNames) {
    if (known == name) return view;
  }
  return std::nullopt;
}

std::vector<std::string_view> view_names() {
  std::vector<std::string_view> names;
  for (const auto& [view, name] : kViewNames) names.push_back(name);
  return names;
}

Camera framing(const mesh::Bounds& asked, View view, double aspect) {
  const mesh::Bounds bounds = framable(asked);
  const model::Vector3 center = 0.5 * (bounds.min + bounds.max);
  Camera camera;
  camera.forward = unit(-1.0 * towards_eye(view));
  const model::Vector3 upward =
      view == View::kTop ? model::Vector3{1, 0, 0} : model::Vector3{0, 0, 1};
  camera.right = unit(cross(camera.forward, upward));
  camera.up = cross(camera.right, camera.forward);

  if (view != View::kPerspective) {
    double width = 0;
    double height = 0;
    for (const model::Vector3& corner : corners_of(bounds)) {
      width = std::max(width, 2 * std::abs(dot(corner - center, camera.right)));
      height = std::max(height, 2 * std::abs(dot(corner - center, camera.up)));
    }
    camera.height = std::max(height, width / aspect) / kFilled;
    camera.eye = center - length(bounds.max - bounds.min) * camera.forward;
    return camera;
  }
  camera.field_of_view = kFieldOfView;
  const double k_up = kFilled * std::tan(kFieldOfView / 2);
  const double k_right = k_up * aspect;
  EyeLimits across;
  EyeLimits upright;
  for (const model::Vector3& corner : corners_of(bounds)) {
    const model::Vector3 p = corner - center;
    const double c = dot(p, camera.forward);
    const double a = dot(p, camera.right);
    const double b = dot(p, camera.up);
    across.right = std::max(across.right, a - k_right * c);
    across.left = std::min(across.left, a + k_right * c);
    upright.right = std::max(upright.right, b - k_up * c);
    upright.left = std::min(upright.left, b + k_up * c);
  }
  const double ahead = std::min(across.farthest_ahead(k_right), upright.farthest_ahead(k_up));
  camera.eye = center + across.middle() * camera.right + upright.middle() * camera.up +
               ahead * camera.forward;
  return camera;
}

std::optional<Projected> project(const Camera& camera, double aspect, const model::Vector3& point) {
  const model::Vector3 p = point - camera.eye;
  Projected projected;
  projected.depth = dot(p, camera.forward);
  if (projected.depth <= 0) return std::nullopt;
  const bool pinhole = camera.field_of_view > 0;
  const double half =
      pinhole ? projected.depth * std::tan(camera.field_of_view / 2) : camera.height / 2;
  projected.x = dot(p, camera.right) / (half * aspect);
  projected.y = dot(p, camera.up) / half;
  return projected;
}

}  // namespace rigor::view
