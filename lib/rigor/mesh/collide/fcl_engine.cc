// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The module rigor-collider.so: `ColliderEngine` by FCL.

#include <exception>
#include <string_view>
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

#include <rigor/mesh/collide/collider_module.h>

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

class FclShape final : public ColliderShape {
 public:
  explicit FclShape(std::unique_ptr<const fcl::CollisionGeometryd> geometry)
      : geometry_(std::move(geometry)) {}
  const fcl::CollisionGeometryd* geometry() const { return geometry_.get(); }

 private:
  std::unique_ptr<const fcl::CollisionGeometryd> geometry_;
};

class FclEngine final : public ColliderEngine {
 public:
  Shape box(const Vector3& sides) const override {
    return shape<fcl::Boxd>(sides.x, sides.y, sides.z);
  }
  Shape sphere(double radius) const override { return shape<fcl::Sphered>(radius); }
  Shape ellipsoid(const Vector3& radii) const override {
    return shape<fcl::Ellipsoidd>(radii.x, radii.y, radii.z);
  }
  Shape cylinder(double radius, double length) const override {
    return shape<fcl::Cylinderd>(radius, length);
  }
  Shape capsule(double radius, double length) const override {
    return shape<fcl::Capsuled>(radius, length);
  }
  Shape cone(double radius, double length) const override {
    return shape<fcl::Coned>(radius, length);
  }

  Shape surface(const TriangleMesh& mesh, const Vector3& scale) const override {
    std::vector<fcl::Vector3d> points;
    points.reserve(mesh.positions.size());
    for (const Vector3& p : mesh.positions)
      points.emplace_back(scale.x * p.x, scale.y * p.y, scale.z * p.z);
    std::vector<fcl::Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    auto model = std::make_unique<SurfaceModel>();
    model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size()));
    model->addSubModel(points, triangles);
    model->endModel();
    return std::make_unique<const FclShape>(std::move(model));
  }

  bool collide(const ColliderShape& a, const model::Pose& X_WA, const ColliderShape& b,
               const model::Pose& X_WB) const override {
    const fcl::CollisionRequestd request;  // whether, not where
    fcl::CollisionResultd result;
    try {
      return fcl::collide(static_cast<const FclShape&>(a).geometry(), transform_of(X_WA),
                          static_cast<const FclShape&>(b).geometry(), transform_of(X_WB), request,
                          result) > 0;
    } catch (const std::exception&) {
      return true;  // its arithmetic failed, which degenerate triangles make it do
    }
  }

 private:
  template <class Geometry, class... Sizes>
  static Shape shape(Sizes... sizes) {
    return std::make_unique<const FclShape>(std::make_unique<const Geometry>(sizes...));
  }
};

}  // namespace
}  // namespace rigor::mesh

const rigor::mesh::ColliderEngine* rigor_make_collider_engine(const char* version) {
  if (std::string_view(version) != RIGOR_VERSION) return nullptr;
  return new rigor::mesh::FclEngine;
}
