// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Turns triangles so that neighbors agree, and closed bodies so that they face outward.
//
//   turn_consistent(work);   // most triangles of each patch stay as they are
//   face_outward(mesh);      // what lies in a body that is turned is turned with it

#pragma once

#include <cstdint>

#include <rigor/mesh/repair/workpiece.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// In each patch, which is triangles joined by edges of two, the fewer are turned. A patch that no
/// turning makes consistent (a Möbius strip) stays when that does not leave fewer bad edges. Returns
/// how many triangles were turned.
std::uint64_t turn_consistent(Workpiece& work);

/// Turns each closed component that lies in no other and is inside out, and with it all that lie in
/// it: so cavities stay cavities. Open components stay: they have no outside. Returns how many
/// components were turned.
std::uint64_t face_outward(TriangleMesh& mesh);

}  // namespace rigor::mesh
