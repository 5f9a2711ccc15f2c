// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How far two surfaces are from each other, at most: what a mesh lost by being simplified, say.
//
// Every corner of each mesh is asked for the distance to the other one's surface, and so are samples
// spread evenly over it; the greatest answer counts. Distances from places to surfaces are those to the
// next triangle, not to a sample. So what is told is never more than the true (Hausdorff) distance, but
// for rounding, and less only by what happens between samples: the distance changes no faster than the
// place. (N. Aspert, D. Santa-Cruz, T. Ebrahimi, "MESH: measuring errors between surfaces using the
// Hausdorff distance", 2002. That most samples need no full search: A. Taha, A. Hanbury, "An efficient
// algorithm for calculating the exact Hausdorff distance", 2015.)
//
//   const Deviation d = deviation(original, simplified, 100'000);
//   if (d.hausdorff() > tolerance) say("differs by %g, examined every %g", …, d.spacing);

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// More samples are not taken: at 10 million, a surface of 1 m² is seen every third of a millimeter.
inline constexpr std::size_t kMaxSamples = 10'000'000;

/// Looks at boxes and triangles from each mesh, after which no more samples are taken: some ten
/// seconds. Meshes of 100,000 triangles take a tenth of that; a speck in the middle of a ball, to which
/// all triangles are equally near, would take hours.
inline constexpr std::uint64_t kMaxDeviationLooks = 200'000'000;

/// In the meshes' unit.
struct Deviation {
  double from_a =
      0;  ///< the farthest that a place of a is from b; infinite when b has no triangles
  double from_b = 0;

  /// There is a sample for each square of this side, on the mesh with the larger area: an estimate of
  /// how much more the true distance can be.
  double spacing = 0;

  bool complete = true;  ///< whether all samples were taken

  double hausdorff() const { return std::max(from_a, from_b); }
};

/// `samples` on each mesh, besides its corners. Triangles out of reach (bvh.h) are left out. The same
/// meshes give the same answer.
Deviation deviation(const TriangleMesh& a, const TriangleMesh& b, std::size_t samples);

}  // namespace rigor::mesh
