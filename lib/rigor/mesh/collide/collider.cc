// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collide/collider.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

namespace rigor::mesh {
namespace {

using SurfaceModel = fcl::BVHModel<fcl::OBBRSSd>;

fcl::Transform3d transform_of(const model::Pose& X) {
  fcl::Transform3d T = fcl::Transform3d::Identity();
  const auto& q = X.rotation;
  T.linear() = fcl::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  T.translation() = fcl::Vector3d(X.translation.x, X.translation.y, X.translation.z);
  return T;
}

Ball ball_around(const std::vector<fcl::Vector3d>& points) {
  fcl::Vector3d low = points.front(), high = points.front();
  for (const fcl::Vector3d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const fcl::Vector3d center = 0.5 * (low + high);
  double squared = 0;
  for (const fcl::Vector3d& p : points) squared = std::max(squared, (p - center).squaredNorm());
  return {{center.x(), center.y(), center.z()}, std::sqrt(squared)};
}

}  // namespace

bool can_collide() { return true; }

struct Collider::Geometry {
  std::unique_ptr<fcl::CollisionGeometryd> shape;
};

Collider::Collider(std::unique_ptr<const Geometry> geometry, const Ball& ball_S)
    : geometry_(std::move(geometry)), ball_S_(ball_S) {}
Collider::Collider(Collider&&) noexcept = default;
Collider& Collider::operator=(Collider&&) noexcept = default;
Collider::~Collider() = default;

Collider Collider::box(const Vector3& sides) {
  auto shape = std::make_unique<fcl::Boxd>(sides.x, sides.y, sides.z);
  return {std::make_unique<const Geometry>(Geometry{std::move(shape)}), {{}, length(sides) / 2}};
}

Collider Collider::sphere(double radius) {
  auto shape = std::make_unique<fcl::Sphered>(radius);
  return {std::make_unique<const Geometry>(Geometry{std::move(shape)}), {{}, radius}};
}

Collider Collider::ellipsoid(const Vector3& radii) {
  auto shape = std::make_unique<fcl::Ellipsoidd>(radii.x, radii.y, radii.z);
  const double radius = std::max({radii.x, radii.y, radii.z});
  return {std::make_unique<const Geometry>(Geometry{std::move(shape)}), {{}, radius}};
}

Collider Collider::cylinder(double radius, double length) {
  auto shape = std::make_unique<fcl::Cylinderd>(radius, length);
  return {std::make_unique<const Geometry>(Geometry{std::move(shape)}),
          {{}, std::hypot(radius, length / 2)}};
}

Collider Collider::capsule(double radius, double length) {
  auto shape = std::make_unique<fcl::Capsuled>(radius, length);
  return {std::make_unique<const Geometry>(Geometry{std::move(shape)}), {{}, radius + length / 2}};
}

Collider Collider::cone(double radius, double length) {
  auto shape = std::make_unique<fcl::Coned>(radius, length);
  return {std::make_unique<const Geometry>(Geometry{std::move(shape)}),
          {{}, std::hypot(radius, length / 2)}};
}

Collider Collider::surface(const TriangleMesh& mesh, const Vector3& scale) {
  std::vector<fcl::Vector3d> points;
  points.reserve(mesh.positions.size());
  for (const Vector3& p : mesh.positions)
    points.emplace_back(scale.x * p.x, scale.y * p.y, scale.z * p.z);
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  auto shape = std::make_unique<SurfaceModel>();
  shape->beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size()));
  shape->addSubModel(points, triangles);
  shape->endModel();
  return {std::make_unique<const Geometry>(Geometry{std::move(shape)}), ball_around(points)};
}

bool collide(const Collider& a, const model::Pose& X_WA, const Collider& b,
             const model::Pose& X_WB) {
  const fcl::CollisionRequestd request;  // whether, not where
  fcl::CollisionResultd result;
  try {
    return fcl::collide(a.geometry_->shape.get(), transform_of(X_WA), b.geometry_->shape.get(),
                        transform_of(X_WB), request, result) > 0;
  } catch (const std::exception&) {
    return true;  // its arithmetic failed, which degenerate triangles make it do
  }
}

}  // namespace rigor::mesh
