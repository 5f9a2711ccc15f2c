// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Fills the small holes of a mesh with triangles on the vertices that are there.
//
// Smallest first, until the area that was filled would pass its share of the mesh's: a triangle that
// went missing is put back, the mouth of a cup stays open. A crack between an edge and a vertex on it
// is a hole of no area; the triangle at the edge is split there. A filling that would make any
// defect more frequent is taken back. The border of
// a sheet is not a hole: a filling would be its other side.
//
//   HolesFilled done = fill_holes(work, {.max_area_share = 0.02});

#pragma once

#include <cstddef>
#include <cstdint>

#include <rigor/mesh/repair/workpiece.h>

namespace rigor::mesh {

struct HoleLimits {
  /// Area of all fillings over that of the mesh. A fiftieth closes what was lost, not what was meant:
  /// a mesh with one hundredth of its triangles missing has less, a box without lid more.
  double max_area_share = 0.02;
  std::size_t max_edges = 1000;  ///< of a hole; the time for one grows with their square
};

struct HolesFilled {
  std::uint64_t filled = 0;
  std::uint64_t triangles = 0;  ///< that were added for it
  std::uint64_t too_large = 0;  ///< holes left for their area or edges, or as the border of a sheet
  std::uint64_t left = 0;       ///< that cannot be filled without making something worse, or soon
  double area = 0;              ///< that was filled, in the mesh's unit squared
  double mesh_area = 0;         ///< before
};

HolesFilled fill_holes(Workpiece& work, const HoleLimits& limits);

}  // namespace rigor::mesh
