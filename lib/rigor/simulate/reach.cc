// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/reach.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor::simulate {
namespace {

Vector3 unit_or_zero(const Vector3& v) {
  const double size = length(v);
  return size > 0 ? (1 / size) * v : Vector3{};
}

/// The rims of a cylinder: where they are lowest (`down` is in the shape's frame), and seven more.
template <class See>
void see_rims(const mesh::Cylinder& cylinder, const Vector3& down, const See& see) {
  const Vector3 across = unit_or_zero({down.x, down.y, 0});
  const double begin = std::atan2(across.y, across.x);
  for (const double end : {-0.5, 0.5}) {
    for (int i = 0; i < 8; ++i) {
      const double angle = begin + i * std::numbers::pi / 4;
      see(Vector3{cylinder.radius * std::cos(angle), cylinder.radius * std::sin(angle),
                  end * cylinder.length});
    }
  }
}

/// Shows the points of a shape, in its frame, among which is the farthest in any direction of a few; of
/// balls and capsules the middles of what `ball_radius` is of.
template <class See>
void see_points(const Scene& scene, const SceneShape& shape, const Vector3& toward,
                const See& see) {
  if (const auto* box = std::get_if<mesh::Box>(&shape.kind)) {
    for (int i = 0; i < 8; ++i) {
      see(Vector3{((i & 1) - 0.5) * box->size.x, ((i >> 1 & 1) - 0.5) * box->size.y,
                  ((i >> 2 & 1) - 0.5) * box->size.z});
    }
  } else if (std::holds_alternative<mesh::Sphere>(shape.kind)) {
    see(Vector3{});
  } else if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape.kind)) {
    see_rims(*cylinder, toward, see);
  } else if (const auto* capsule = std::get_if<mesh::Capsule>(&shape.kind)) {
    for (const double end : {-0.5, 0.5}) see(Vector3{0, 0, end * capsule->length});
  } else if (const auto* hull = std::get_if<ConvexHull>(&shape.kind)) {
    for (const Vector3& p : scene.meshes[hull->mesh].positions) see(p);
  } else if (const auto* soup = std::get_if<TriangleSoup>(&shape.kind)) {
    for (const Vector3& p : scene.meshes[soup->mesh].positions) see(p);
  }
}

/// m: the radius of a ball about each of a shape's points that belongs to it.
double ball_radius(const SceneShape& shape) {
  if (const auto* sphere = std::get_if<mesh::Sphere>(&shape.kind)) return sphere->radius;
  const auto* capsule = std::get_if<mesh::Capsule>(&shape.kind);
  return capsule != nullptr ? capsule->radius : 0;
}

}  // namespace

Pose start_pose(const Scene& scene, const SceneShape& shape) {
  return shape.body < scene.bodies.size() ? compose(scene.bodies[shape.body].X_WB, shape.X_BS)
                                          : shape.X_BS;
}

double reach(const Scene& scene, const SceneShape& shape, const Vector3& direction_W) {
  if (std::holds_alternative<HalfSpace>(shape.kind) ||
      std::holds_alternative<HeightGrid>(shape.kind)) {
    return kInfinity;
  }
  const Pose X_WS = start_pose(scene, shape);
  const Vector3 toward = rotate(conjugate(X_WS.rotation), direction_W);
  double farthest = -kInfinity;
  see_points(scene, shape, toward,
             [&](const Vector3& p) { farthest = std::max(farthest, dot(p, toward)); });
  return farthest + ball_radius(shape) * length(direction_W) + dot(X_WS.translation, direction_W);
}

std::vector<Vector3> low_points(const Scene& scene, const SceneShape& shape, double height) {
  const Pose X_WS = start_pose(scene, shape);
  const Vector3 down = rotate(conjugate(X_WS.rotation), {0, 0, -1});
  const Vector3 below = ball_radius(shape) * Vector3{0, 0, -1};
  std::vector<Vector3> low;
  see_points(scene, shape, down, [&](const Vector3& p) {
    const Vector3 p_W = transform(X_WS, p) + below;
    if (p_W.z <= height) low.push_back(p_W);
  });
  return low;
}

LowestPoints::LowestPoints(const Scene& scene)
    : of_body(scene.bodies.size(), kInfinity), of_model(scene.models.size(), kInfinity) {
  of_shape.reserve(scene.shapes.size());
  for (const SceneShape& shape : scene.shapes) {
    const double low = -reach(scene, shape, {0, 0, -1});
    of_shape.push_back(low);
    if (shape.body >= scene.bodies.size()) continue;
    of_body[shape.body] = std::min(of_body[shape.body], low);
    if (low == -kInfinity) continue;
    double& of = of_model[scene.bodies[shape.body].model];
    of = std::min(of, low);
  }
}

double lowest_of_model(const Scene& scene, std::uint32_t model) {
  double lowest = kInfinity;
  for (const SceneShape& shape : scene.shapes) {
    if (shape.body >= scene.bodies.size() || scene.bodies[shape.body].model != model) continue;
    const double down = reach(scene, shape, {0, 0, -1});
    if (down < kInfinity) lowest = std::min(lowest, -down);  // a plane has no lowest point
  }
  return lowest;
}

}  // namespace rigor::simulate
