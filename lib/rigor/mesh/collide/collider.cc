// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collide/collider.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <rigor/mesh/collide/collider_module.h>
#include <rigor/process/worker_path.h>

namespace rigor::mesh {
namespace {

/// Opened once, by who first asks.
const OpenedColliders& opened_colliders() {
  static const OpenedColliders kOpened =
      open_colliders(process::path_beside_worker(kColliderModule));
  return kOpened;
}

const ColliderEngine& collider_engine() {
  const OpenedColliders& opened = opened_colliders();
  if (!opened.engine) throw std::logic_error(opened.problem);
  return *opened.engine;
}

/// In the scaled mesh's frame, of all of its positions.
Ball ball_around(const TriangleMesh& mesh, const Vector3& scale) {
  const auto scaled = [&](const Vector3& p) {
    return Vector3{scale.x * p.x, scale.y * p.y, scale.z * p.z};
  };
  Vector3 low = scaled(mesh.positions.front()), high = low;
  for (const Vector3& position : mesh.positions) {
    const Vector3 p = scaled(position);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  Ball ball{0.5 * (low + high), 0};
  for (const Vector3& position : mesh.positions)
    ball.radius = std::max(ball.radius, length(scaled(position) - ball.center));
  return ball;
}

}  // namespace

std::string collider_problem() { return opened_colliders().problem; }

Collider::Collider(std::unique_ptr<const ColliderShape> shape, const Ball& ball_S)
    : shape_(std::move(shape)), ball_S_(ball_S) {}
Collider::Collider(Collider&&) noexcept = default;
Collider& Collider::operator=(Collider&&) noexcept = default;
Collider::~Collider() = default;

Collider Collider::box(const Vector3& sides) {
  return {collider_engine().box(sides), {{}, length(sides) / 2}};
}

Collider Collider::sphere(double radius) {
  return {collider_engine().sphere(radius), {{}, radius}};
}

Collider Collider::ellipsoid(const Vector3& radii) {
  return {collider_engine().ellipsoid(radii), {{}, std::max({radii.x, radii.y, radii.z})}};
}

Collider Collider::cylinder(double radius, double length) {
  return {collider_engine().cylinder(radius, length), {{}, std::hypot(radius, length / 2)}};
}

Collider Collider::capsule(double radius, double length) {
  return {collider_engine().capsule(radius, length), {{}, radius + length / 2}};
}

Collider Collider::cone(double radius, double length) {
  return {collider_engine().cone(radius, length), {{}, std::hypot(radius, length / 2)}};
}

Collider Collider::surface(const TriangleMesh& mesh, const Vector3& scale) {
  return {collider_engine().surface(mesh, scale), ball_around(mesh, scale)};
}

bool collide(const Collider& a, const model::Pose& X_WA, const Collider& b,
             const model::Pose& X_WB) {
  return collider_engine().collide(*a.shape_, X_WA, *b.shape_, X_WB);
}

}  // namespace rigor::mesh
