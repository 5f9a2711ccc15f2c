// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes as the bytes of a file: the same mesh gives the same bytes on any machine and any day.
//
//   WrittenMesh written = write_mesh(mesh, "meshes/wheel.dae");
//   if (!written.bytes) complain(written.problem);
//
// | ending | coordinates         | parts                                                     |
// |--------|---------------------|-----------------------------------------------------------|
// | .stl   | 32-bit              | forgotten                                                 |
// | .obj   | decimal, exact      | `o` and `usemtl`; equal neighbours become one             |
// | .dae   | decimal, exact      | a geometry and a node each; unit 1 m, Z_UP; flat normals  |
// | .glb   | 32-bit              | a mesh and a node each                                    |
// | .ply   | 32-bit if exact so, | forgotten                                                 |
// |        | otherwise 64-bit    |                                                           |
//
// Triangles keep their order and their first corner. All but STL weld corners of equal coordinates
// (in .dae and .glb within a part) and leave out positions that no triangle uses. -0 is written as
// 0. A part without a name, or a material, gets none; readers then make one up.
//
// assimp holds 32-bit numbers. Of a .dae it reads coordinates that are such numbers exactly (from a
// micrometre on), others within two units of the last place (among 396 real meshes).
//
// A .glb holds the coordinates as they are, without a node that would turn z up to the format's y
// up: Gazebo, and rigor's own reader, place glTF's x, y and z as a link's x, y and z. A viewer of
// glTF shows the model lying on its back.

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct WrittenMesh {
  std::optional<std::string> bytes;
  std::string problem;  ///< why there are no bytes
};

/// By the path's ending; nothing is written to a disk. There are no bytes for another ending, for
/// coordinates that are not finite or, in the 32-bit formats, over 3.4e38, and for more triangles
/// than rigor reads (kMaxTriangles).
WrittenMesh write_mesh(const TriangleMesh& mesh, std::string_view path);

// What follows takes coordinates that the format can hold. A mesh without triangles gives a file
// that holds none. In names, tabs and line ends become spaces, what XML or UTF-8 does not allow
// U+FFFD.

std::string write_stl(const TriangleMesh& mesh);  ///< binary
std::string write_obj(const TriangleMesh& mesh);
std::string write_collada(const TriangleMesh& mesh);
std::string write_glb(const TriangleMesh& mesh);
std::string write_ply(const TriangleMesh& mesh);  ///< binary, little-endian

}  // namespace rigor::mesh
