// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a mesh goes through itself: pairs of its triangles that meet in more than what they share.
//
// Corners are first welded by position, exactly (mesh/topology/weld.h). Then two triangles that share
//   - no place intersect when they touch or cross at all,
//   - one place intersect when they have another place in common,
//   - two places, an edge, intersect when they lie in one plane and overlap there,
//   - three places are a duplicate, which mesh/topology/topology.h counts, and don't intersect.
// These are the rules of CGAL's Polygon_mesh_processing::self_intersections, but for two things: it
// knows shared edges and corners from its half-edges, so that it sees faces that only touch where the
// surface is not a manifold, and duplicates too; and it adds each degenerate face as a pair with itself.
//
// The answer does not depend on rounding (predicate.h): coordinates are taken for exactly what they are.
//
//   const SelfIntersections found = self_intersections(mesh);
//   if (found.pairs > 0) show(found.examples[0].at);

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// No more are counted: whether it is a million pairs or two changes nothing.
inline constexpr std::uint64_t kMaxIntersectingPairs = 1'000'000;

/// So many looks at boxes and pairs of triangles are taken, and so many more for each triangle. Real
/// meshes take 10 to 100 a triangle; the first, ten seconds at worst, keeps small ones of long, thin
/// triangles complete.
inline constexpr std::uint64_t kMaxIntersectionLooks = 20'000'000;
inline constexpr std::uint64_t kMaxIntersectionLooksEach = 200;

inline constexpr std::size_t kMaxIntersectionExamples = 8;

struct Intersection {
  std::array<std::uint64_t, 2> triangles{};  ///< indices into the mesh's, the lower one first
  Vector3 at;  ///< in both; of thin ones in one plane, to a hundredth of the mesh
};

struct SelfIntersections {
  std::uint64_t pairs = 0;
  bool complete = true;  ///< whether all pairs were examined; if not, there may be more

  /// Triangles that were not examined: without an area, or with coordinates out of range (bvh.h,
  /// predicate.h).
  std::uint64_t left_out = 0;

  std::vector<Intersection> examples;  ///< those of the lowest triangles, of all that were counted
};

SelfIntersections self_intersections(const TriangleMesh& mesh);

}  // namespace rigor::mesh
