// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The holes of a mesh: the loops that its edges of one triangle form.
//
// From one such edge the next is found by going round their common vertex from triangle to triangle, so
// surfaces that touch in a vertex keep their loops apart. A loop that passes a vertex twice is two
// that touch there, and is cut into these.
//
//   for (const Hole& hole : holes_of(work)) fill(hole);

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/mesh/repair/workpiece.h>

namespace rigor::mesh {

struct Hole {
  /// Different ones, at least three. A triangle that fills the hole runs from one to the next.
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> faces;  ///< at the edge from each vertex to the next
};

/// In the order of their first edges. Loops that end at edges of three triangles are passed over.
std::vector<Hole> holes_of(const Workpiece& work);

}  // namespace rigor::mesh
