// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Seams: borders of a mesh that run along each other and differ by rounding only, as 0 and 6e-18 do.
//
//   joined = close_seams(work);

#pragma once

#include <cstdint>

#include <rigor/mesh/repair/workpiece.h>

namespace rigor::mesh {

/// Vertices at holes are one when they are this near, times the greatest coordinate of the mesh: some
/// roundings of the numbers with which whoever wrote the file computed.
inline constexpr double kSeamDistance = 8 * 2.220446049250313e-16;

/// Returns how many vertices were joined to others. What would make a defect more frequent is left.
std::uint64_t close_seams(Workpiece& work);

}  // namespace rigor::mesh
