// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rigid shapes that are held against each other: whether two of them touch at given poses. Boxes, spheres
// and the like are what their numbers say; a mesh is its triangles, a surface without an inside, as motion
// planners take it. Answered by FCL (https://github.com/flexible-collision-library/fcl), which is in a module
// that is opened when a shape is first made (`collider_module.h`): who makes none does not load it.
//
//   if (const std::string problem = collider_problem(); !problem.empty()) return problem;
//   const Collider arm = Collider::surface(loaded.mesh, {1, 1, 1});
//   const Collider box = Collider::box({1, 1, 0.1});
//   if (collide(arm, X_WA, box, X_WB)) …
//
// Shapes have their own frame S: a cylinder, a capsule and a cone have their axis along z and their middle at
// the origin (a cone's: half of its height). Lengths in meters. Immutable, so safe across threads.

#pragma once

#include <memory>
#include <string>

#include <rigor/mesh/ball.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/pose.h>

namespace rigor::mesh {

class ColliderShape;

/// Why no shape can be made: "…/rigor-collider.so: cannot open shared object file: …", as in a build without FCL.
/// Empty where they can. With a problem, every shape throws std::logic_error when it is made.
std::string collider_problem();

class Collider {
 public:
  static Collider box(const Vector3& sides);
  static Collider sphere(double radius);
  static Collider ellipsoid(const Vector3& radii);
  static Collider cylinder(double radius, double length);
  /// `length` is without the two half spheres.
  static Collider capsule(double radius, double length);
  static Collider cone(double radius, double length);
  /// All triangles with their corners multiplied by the scale. At least one triangle.
  static Collider surface(const TriangleMesh& mesh, const Vector3& scale);

  Collider(Collider&&) noexcept;
  Collider& operator=(Collider&&) noexcept;
  ~Collider();

  /// A ball around the shape, in its frame.
  const Ball& ball_S() const { return ball_S_; }

 private:
  Collider(std::unique_ptr<const ColliderShape> shape, const Ball& ball_S);
  friend bool collide(const Collider& a, const model::Pose& X_WA, const Collider& b,
                      const model::Pose& X_WB);

  std::unique_ptr<const ColliderShape> shape_;
  Ball ball_S_;
};

/// Whether they have a point in common. FCL's tolerance is 1e-6 m where one of them is round. What FCL fails to
/// decide counts as touching.
bool collide(const Collider& a, const model::Pose& X_WA, const Collider& b,
             const model::Pose& X_WB);

}  // namespace rigor::mesh
