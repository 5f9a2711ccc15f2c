// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes away triangles that bound nothing: those with two corners in one place or three on a line,
// and copies of others. Each function returns how many triangles are gone; what would make a defect
// more frequent is left.
//
//   Workpiece work(std::move(mesh));
//   drop_degenerate(work);
//   drop_duplicates(work);
//   drop_lines(work);

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/mesh/repair/workpiece.h>

namespace rigor::mesh {

std::uint64_t drop_degenerate(Workpiece& work);

/// Where two bodies have a wall in common, each with its own copy facing away from the other, both
/// copies go and the bodies become one. Of other copies one stays, whatever side they face; the first, if
/// its neighbors agree with it.
std::uint64_t drop_duplicates(Workpiece& work);

/// Triangles of no area. As their corners hold together what else would be a crack, the neighbor at the
/// longest edge is split at the third corner instead (a flip of that edge), and the line is gone.
std::uint64_t drop_lines(Workpiece& work);

/// The same for these triangles only.
std::uint64_t drop_lines(Workpiece& work, std::vector<std::uint32_t> faces);

}  // namespace rigor::mesh
