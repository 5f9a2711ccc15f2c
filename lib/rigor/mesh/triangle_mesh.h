// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Triangles in space, as they were read from a file.
//
// Coordinates are doubles in the mesh's own frame, in meters unless the file says nothing of its unit
// (STL, OBJ), then in whatever its author used. Vertices are those of the file: nothing is welded.
//
//   for (const Triangle& t : mesh.triangles) sum += area(facet(mesh, t));

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <rigor/model/pose.h>

namespace rigor::mesh {

using model::Vector3;

/// Corners as indices into the positions, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// Which of its corners each side runs between.
inline constexpr std::array<std::array<std::size_t, 2>, 3> kSides{{{0, 1}, {1, 2}, {2, 0}}};

/// A run of triangles that the file keeps apart: a solid of an STL, an object, group or material of
/// an OBJ, a mesh of a scene.
struct Part {
  std::string name;
  std::string material;
  std::size_t first = 0;  ///< index of its first triangle
  std::size_t count = 0;
};

/// How a part looks. Parts name it by `Part::material`.
struct Material {
  std::string name;
  std::array<float, 4> diffuse{0.7F, 0.7F, 0.7F, 1};  ///< red, green, blue, opacity: 0 to 1
  std::string texture = {};  ///< the picture of its color, as the file names it; empty without one
  /// The bytes of the picture that the mesh's own file holds (glTF), at most `kMaxEmbeddedPictureBytes` in all; a
  /// material has one or the other.
  std::shared_ptr<const std::string> embedded_picture = nullptr;
  bool picture_opacity = false;  ///< where the picture lets light through, the surface does
};

inline constexpr std::size_t kMaxEmbeddedPictureBytes = std::size_t{64} << 20U;

/// What the corners of triangles carry besides their positions. Each list is empty, when nothing of
/// the mesh carries that, or has one entry a triangle.
struct Corners {
  using Texture = std::array<float, 2>;  ///< u to the right, v up, from the picture's lower left
  using Normal = std::array<float, 3>;   ///< of length 1, or 0 when there is none
  using Color = std::array<float, 4>;    ///< red, green, blue, opacity: 0 to 1

  std::vector<std::array<Texture, 3>> texture;
  std::vector<std::array<Normal, 3>> normals;
  std::vector<std::array<Color, 3>> colors;
};

/// What a corner without a color has where another has one.
inline constexpr Corners::Color kWhite{1, 1, 1, 1};

struct TriangleMesh {
  std::vector<Vector3> positions;
  std::vector<Triangle> triangles;
  std::vector<Part> parts;          ///< in the order of their triangles, which they cover
  std::vector<Material> materials;  ///< of different names
  Corners corners;
};

/// The places of one triangle's corners.
using Facet = std::array<Vector3, 3>;

inline Facet facet(const TriangleMesh& mesh, const Triangle& t) {
  return {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
}

/// Along the normal, twice as long as the area.
inline Vector3 area_vector(const Facet& f) { return cross(f[1] - f[0], f[2] - f[0]); }

inline double area(const Facet& f) { return length(area_vector(f)) / 2; }

/// Axis-aligned; `min` is above `max` when it holds nothing.
struct Bounds {
  Vector3 min;
  Vector3 max;
};

Bounds bounds_of(const std::vector<Vector3>& positions);
double diagonal(const Bounds& bounds);

}  // namespace rigor::mesh
