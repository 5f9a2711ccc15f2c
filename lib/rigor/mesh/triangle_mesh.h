// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Triangles in space, as they were read from a file.
//
// Coordinates are doubles in the mesh's own frame, in metres unless the file says nothing of its unit
// (STL, OBJ), then in whatever its author used. Vertices are those of the file: nothing is welded.
//
//   for (const Triangle& t : mesh.triangles) area += area_of(mesh.positions[t[0]], …);

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <rigor/model/pose.h>

namespace rigor::mesh {

using model::Vector3;

/// Corners as indices into the positions, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// A run of triangles that the file keeps apart: a solid of an STL, an object, group or material of
/// an OBJ, a mesh of a scene.
struct Part {
  std::string name;
  std::string material;
  std::size_t first = 0;  ///< index of its first triangle
  std::size_t count = 0;
};

struct TriangleMesh {
  std::vector<Vector3> positions;
  std::vector<Triangle> triangles;
  std::vector<Part> parts;  ///< in the order of their triangles, which they cover
};

/// The corners of one triangle.
using Facet = std::array<Vector3, 3>;

inline Facet facet(const TriangleMesh& mesh, const Triangle& t) {
  return {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
}

/// Axis-aligned; `min` is above `max` when it holds nothing.
struct Bounds {
  Vector3 min;
  Vector3 max;
};

Bounds bounds_of(const std::vector<Vector3>& positions);
double diagonal(const Bounds& bounds);

}  // namespace rigor::mesh
