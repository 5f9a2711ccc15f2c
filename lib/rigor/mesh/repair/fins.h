// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Small patches of triangles that hang on edges of three or more, and close nothing: flaps that end in
// the open, and walls inside.
//
//   dropped = drop_fins(work, 0.001);

#pragma once

#include <cstdint>

#include <rigor/mesh/repair/workpiece.h>

namespace rigor::mesh {

/// Takes away patches, which end at edges of one or of more than two triangles, the smallest first, as
/// long as their area stays below this share of the mesh's, and only when less edges of more than two
/// triangles are left. Returns how many triangles are gone.
std::uint64_t drop_fins(Workpiece& work, double max_area_share);

}  // namespace rigor::mesh
