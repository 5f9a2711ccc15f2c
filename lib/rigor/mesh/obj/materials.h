// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The material library beside an OBJ (.mtl): names, diffuse colors (`Kd`), opacity (`d`, or `Tr`
// from 1 down), and the pictures of colors (`map_Kd`).
//
//   std::vector<Material> materials = read_obj_materials("newmtl steel\nKd 0.5 0.5 0.6\n");

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Of a longer name in an OBJ or its materials, only this much is kept: a file could repeat it for
/// each part.
inline constexpr std::size_t kMaxObjNameBytes = 256;

/// Larger libraries are not read. The largest of 79 real ones has 1,250 bytes.
inline constexpr std::uint64_t kMaxObjMaterialBytes = std::uint64_t{16} << 20U;

/// In their order; of several with one name the first. What cannot be parsed is passed over.
std::vector<Material> read_obj_materials(std::string_view bytes);

/// Those that parts of the mesh name, in the order of the parts; empty when nothing is known of
/// any. Names are those that write_obj gives them.
std::string write_obj_materials(const TriangleMesh& mesh);

/// A blank and the name, as the rest of a line, which a backslash at its end would join to the
/// next.
std::string rest_of_obj_line(const std::string& name);

}  // namespace rigor::mesh
