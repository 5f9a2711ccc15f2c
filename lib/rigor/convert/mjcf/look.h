// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Materials and textures of geoms, and the meshes of which each has one look: a geom of MuJoCo has one material.
// Private to the room.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <rigor/convert/mjcf/draft.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/robot/look.h>

namespace rigor::convert {

/// Gives the geom that color and picture, as a material where it has a name or a picture. A picture becomes a file in
/// `assets/`: stretched over a mesh by its texture points, over a plane, or over each face of a cube around other
/// shapes.
void set_mjcf_look(MjcfDraft& draft, MjcfElement& geom, const std::string& name,
                   const robot::Look& look);

/// Parts of a mesh that look alike.
struct MjcfMeshGroup {
  std::vector<std::size_t> parts;  ///< indices
  std::string name;                ///< of the first part's material
  robot::Look look;
};

/// In the order of their first parts. `looks` has one for each part, or one for all. None where there
/// would be more than MuJoCo's users want: a hundred.
std::vector<MjcfMeshGroup> grouped_by_look(const std::vector<mesh::Part>& parts,
                                           const std::vector<robot::Look>& looks);

}  // namespace rigor::convert
