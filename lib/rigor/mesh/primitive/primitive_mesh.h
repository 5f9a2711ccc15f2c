// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The shapes that physics engines collide best, with plain numbers, and as meshes.
//
// Dimensions are SDFormat's: each shape is centered at its origin, its length along z.
//
//   const TriangleMesh drawn = mesh_of(Capsule{.radius = 0.1, .length = 0.5});

#pragma once

#include <variant>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct Box {
  Vector3 size;  ///< full side lengths
};

struct Sphere {
  double radius = 0;
};

struct Cylinder {
  double radius = 0;
  double length = 0;
};

struct Capsule {
  double radius = 0;
  double length = 0;  ///< of the cylindrical part: the caps add two radii
};

using Primitive = std::variant<Box, Sphere, Cylinder, Capsule>;

double volume_of(const Primitive& primitive);

/// A circle is drawn as so many straight edges, a half circle from pole to pole as half as many:
/// a 64-gon is within 0.12 % of its circle's radius.
inline constexpr unsigned kCircleSegments = 64;

/// Closed, wound outward, its vertices on the primitive's surface (and in the middle of a cylinder's
/// ends): the mesh of a round one lies inside it.
TriangleMesh mesh_of(const Primitive& primitive);

/// The same of a cone: its base at z = -length/2, its apex at length/2, as SDFormat has it.
TriangleMesh cone_mesh(double radius, double length);

}  // namespace rigor::mesh
