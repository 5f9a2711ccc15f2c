// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is compiled in place of collider.cc without FCL (RIGOR_WITH_FCL=OFF).

#include <stdexcept>

#include <rigor/mesh/collide/collider.h>

namespace rigor::mesh {
namespace {

[[noreturn]] Collider collider_is_absent() {
  throw std::logic_error("rigor was built without FCL");
}

}  // namespace

bool can_collide() { return false; }

struct Collider::Geometry {};

Collider::Collider(std::unique_ptr<const Geometry> geometry, const Ball& ball_S)
    : geometry_(std::move(geometry)), ball_S_(ball_S) {}
Collider::Collider(Collider&&) noexcept = default;
Collider& Collider::operator=(Collider&&) noexcept = default;
Collider::~Collider() = default;

Collider Collider::box(const Vector3&) { return collider_is_absent(); }
Collider Collider::sphere(double) { return collider_is_absent(); }
Collider Collider::ellipsoid(const Vector3&) { return collider_is_absent(); }
Collider Collider::cylinder(double, double) { return collider_is_absent(); }
Collider Collider::capsule(double, double) { return collider_is_absent(); }
Collider Collider::cone(double, double) { return collider_is_absent(); }
Collider Collider::surface(const TriangleMesh&, const Vector3&) { return collider_is_absent(); }

// There are none to call it on.
bool collide(const Collider&, const model::Pose&, const Collider&, const model::Pose&) {
  return false;
}

}  // namespace rigor::mesh
