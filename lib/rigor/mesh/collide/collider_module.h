// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What `Collider` asks of FCL, in a module of its own that is opened when a shape is first made: FCL brings its tree
// of voxels and more, and loading those doubles the time that every command takes to start.
//
//   const OpenedColliders opened = open_colliders(process::path_beside_worker(kColliderModule));
//   if (!opened.engine) return opened.problem;
//   const std::unique_ptr<const ColliderShape> box = opened.engine->box({1, 1, 0.1});
//
// The module is compiled with these headers and linked to nothing of rigor's.

#pragma once

#include <memory>
#include <string>

#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/pose.h>

namespace rigor::mesh {

/// Of the module's own making.
class ColliderShape {
 public:
  virtual ~ColliderShape() = default;
};

/// As `Collider` describes them. Immutable, so safe across threads.
class ColliderEngine {
 public:
  using Shape = std::unique_ptr<const ColliderShape>;

  virtual ~ColliderEngine() = default;
  virtual Shape box(const Vector3& sides) const = 0;
  virtual Shape sphere(double radius) const = 0;
  virtual Shape ellipsoid(const Vector3& radii) const = 0;
  virtual Shape cylinder(double radius, double length) const = 0;
  virtual Shape capsule(double radius, double length) const = 0;
  virtual Shape cone(double radius, double length) const = 0;
  virtual Shape surface(const TriangleMesh& mesh, const Vector3& scale) const = 0;
  virtual bool collide(const ColliderShape& a, const model::Pose& X_WA, const ColliderShape& b,
                       const model::Pose& X_WB) const = 0;
};

/// The file's name, beside the worker's program, and the function in it.
inline constexpr const char* kColliderModule = "rigor-collider.so";
inline constexpr const char* kMakeColliderEngine = "rigor_make_collider_engine";

struct OpenedColliders {
  std::unique_ptr<const ColliderEngine> engine;
  std::string problem;  ///< why there is none: "/usr/libexec/rigor-collider.so: cannot open …"
};

/// The module is never closed, since shapes are of its code.
OpenedColliders open_colliders(const std::string& module);

}  // namespace rigor::mesh

/// The caller owns it. Null when the module is of another version of rigor than `version`.
extern "C" const rigor::mesh::ColliderEngine* rigor_make_collider_engine(const char* version);
