// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh that encloses nothing as MuJoCo weighs it by default (`inertia="legacy"`): each triangle is the base of a
// pyramid whose apex is in the middle of the surface, and every pyramid counts as positive. Their center of mass is
// that of the mesh, and the apex of the pyramids that its volume and inertia are of. For a convex mesh this is what
// it encloses; for any other it is more.

#pragma once

#include <cstdint>
#include <optional>

#include <rigor/mass/polyhedron.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mass {

enum class PyramidSigns : std::uint8_t {
  kPositive,  ///< `inertia="legacy"`
  kAsWound,   ///< `inertia="exact"`: a triangle that looks at its apex takes away
};

/// Nothing for a mesh without area, or whose pyramids do not add up to a volume.
std::optional<PolyhedronMoments> pyramids_of(const mesh::TriangleMesh& mesh,
                                             PyramidSigns signs = PyramidSigns::kPositive);

}  // namespace rigor::mass
