// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A simpler shape in the place of a mesh that collides, within an error bound: a primitive where one fits, else the
// convex hull, else convex pieces, else the same surface with fewer triangles. Of these the first that has at most a
// fifth of the triangles, else the first that has at most half of them, else a hull or pieces with any fewer.
//
//   const auto found = find_substitute(mesh, {.max_error = 0.02 * diagonal(bounds)});
//   if (found) say("%zu triangles, %g m off", found->triangles, found->hausdorff);
//
// The error is the two-sided distance between the surfaces (spatial/distance.h). Where pieces meet or overlap, what lies
// inside of another piece is no surface. So a shape that fills a cavity, or what a shell holds inside, is as far off as
// that is deep.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <rigor/mesh/primitive/fit.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// In the order in which they are tried, of one share of the triangles.
enum class SubstituteKind : std::uint8_t { kPrimitive, kHull, kPieces, kReduced };

enum class Capsules : std::uint8_t { kAllowed, kRefused };

struct SubstituteLimits {
  double max_error = 0;  ///< in the mesh's unit
  Capsules capsules = Capsules::kAllowed;
  SubstituteKind first = SubstituteKind::kPrimitive;  ///< those before it are not tried
  std::size_t pieces = 8;                             ///< at most
};

struct Substitute {
  SubstituteKind kind{};
  std::optional<Fit> primitive;      ///< of kPrimitive
  std::vector<TriangleMesh> meshes;  ///< of the others; several are convex pieces
  std::size_t triangles = 0;         ///< of all meshes; 0 of a primitive
  double hausdorff = 0;              ///< in the mesh's unit
  /// (new - old) / old, where the old volume is that of the mesh; of an open one its hull's, but for kReduced.
  double volume_error = 0;
  bool of_hull = false;  ///< it is the hull's
};

/// Nothing where none keeps within the bound with fewer triangles: of kReduced, half of them.
std::optional<Substitute> find_substitute(const TriangleMesh& mesh, const SubstituteLimits& limits);

/// The surface of what convex pieces fill together, in triangles of about `step` a side.
TriangleMesh outer_skin(const std::vector<TriangleMesh>& pieces, double step);

}  // namespace rigor::mesh
