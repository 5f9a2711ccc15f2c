// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A concave mesh as a few convex pieces, which physics engines collide fast and well.
//
// Each solid is a piece at first. The piece whose hull leaves most empty is cut in two by the plane,
// of several, that leaves least empty in the hulls of what it gives, until there are thrice as many
// pieces as wanted or hardly anything is empty; then those whose common hull adds least are joined
// again. (In the manner of K. Mamou, F. Ghorbel, "A simple and efficient approach for 3D mesh
// approximate convex decomposition", 2009, but with cuts of the surface itself, not of voxels.)
//
//   const Pieces pieces = convex_pieces(mesh, {.count = 16});
//   for (const TriangleMesh& hull : pieces.hulls) write(hull);

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct PieceLimits {
  std::size_t count = 16;    ///< pieces at most, from 1 to kMaxPieces
  double tolerance = 0.005;  ///< empty share of the mesh's volume at which nothing more is cut
};

/// More would be asked of nobody: engines are slower with 64 hulls than with the mesh.
inline constexpr std::size_t kMaxPieces = 64;

/// A solid of more triangles is not cut but taken whole. At this size it takes some ten seconds.
inline constexpr std::size_t kMaxCutTriangles = 20'000;

/// A mesh of more solids gets the one hull round them all: joining them pair by pair would take minutes.
inline constexpr std::size_t kMaxSolids = 1000;

struct Pieces {
  std::vector<TriangleMesh> hulls;  ///< convex, closed, outward; they hold the mesh together
  double hull_volume = 0;           ///< sum of theirs
  /// Sum of the closed solids', overlaps counted twice; nothing when a solid is open.
  std::optional<double> mesh_volume;
  std::uint64_t solids = 0;     ///< that the mesh is made of
  std::uint64_t open = 0;       ///< of them open, so not cut
  std::uint64_t too_large = 0;  ///< of them not cut for their size, or their number
  std::uint64_t flat = 0;       ///< of them without a hull, so in no piece

  /// Volume of the hulls that is not of the mesh: exact where hulls do not overlap, an upper bound
  /// where they do.
  std::optional<double> outside() const {
    if (!mesh_volume) return std::nullopt;
    return hull_volume - *mesh_volume;
  }
};

Pieces convex_pieces(const TriangleMesh& mesh, const PieceLimits& limits);

}  // namespace rigor::mesh
