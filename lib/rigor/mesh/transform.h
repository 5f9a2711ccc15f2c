// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh brought to other units, another size, another up axis and another origin, always in this
// order, so that a command line has one meaning.
//
// Each step is done in double and rounded once: before the centering a coordinate is within 2⁻⁵² of
// its size of what real numbers would give; centering rounds once more. Turning is exact.
//
//   Transformed result = transformed(mesh, {.unit = 0.001, .center = Center::kBounds});
//   // The pose X_LM of the mesh in its link becomes X_LM · translation(-result.translation).

#pragma once

#include <cstdint>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Which axis points up in the mesh as it is.
enum class UpAxis : std::uint8_t {
  kZ,
  kY,  ///< turned by 90° about x: (x, y, z) becomes (x, -z, y)
};

/// What comes to lie at the origin.
enum class Center : std::uint8_t {
  kNone,    ///< the origin that there is
  kPoint,   ///< `Transform::point`, such as the center of mass
  kBounds,  ///< the center of the box around all triangles
  kBottom,  ///< the center of that box's lower face: the lowest corner has z = 0 exactly
};

struct Transform {
  double unit = 1;                ///< meters that a unit of the mesh represents
  Vector3 scale = {1, 1, 1};      ///< along the mesh's own axes; not zero
  UpAxis up = UpAxis::kZ;         ///< of the mesh; z is up in the result
  Center center = Center::kNone;  ///< moved there last
  Vector3 point = {};             ///< for `kPoint`, in the coordinates of the mesh as it is given
};

/// Where a point of the mesh as it is comes to lie before the centering.
Vector3 before_centering(const Transform& by, const Vector3& p);

struct Transformed {
  TriangleMesh mesh;
  Vector3 translation;  ///< of the centering, which was added to each vertex: meters, z up
};

/// A transform that mirrors swaps each triangle's winding, so that its outside stays outside;
/// normals stay perpendicular to what they were, and lean to the same side of the surface. The
/// centering looks only at positions that triangles use; without any there is no translation.
Transformed transformed(TriangleMesh mesh, const Transform& by);

}  // namespace rigor::mesh
