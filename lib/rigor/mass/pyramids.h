// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh that encloses nothing as MuJoCo weighs it by default (`inertia="legacy"`): each triangle is the base of a
// pyramid whose apex is in the middle of the surface, and every pyramid counts as positive. Their center of mass is
// that of the mesh, and the apex of the pyramids that its volume and inertia are of. For a convex mesh this is what
// it encloses; for any other it is more.

#pragma once

#include <optional>

#include <rigor/mass/polyhedron.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mass {

/// Nothing for a mesh without area.
std::optional<PolyhedronMoments> pyramids_of(const mesh::TriangleMesh& mesh);

}  // namespace rigor::mass
