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
// | .obj   | decimal, exact      | `o` and `usemtl`; equal neighbors become one             |
// | .dae   | decimal, exact      | a geometry and a node each; unit 1 m, Z_UP                |
// | .glb   | 32-bit              | a mesh and a node each                                    |
// | .ply   | 32-bit if exact so, | forgotten                                                 |
// |        | otherwise 64-bit    |                                                           |
//
// | ending | texture points   | normals                 | colors         | materials             |
// |--------|------------------|-------------------------|-----------------|-----------------------|
// | .stl   | forgotten        | each triangle's own     | forgotten       | forgotten             |
// | .obj   | exact            | exact                   | without opacity | a .mtl beside it      |
// | .dae   | exact            | exact; each triangle's  | exact           | a color or a picture |
// |        |                  | own where there is none |                 |                       |
// | .glb   | u; v as 1 - v    | exact                   | exact           | all                   |
// | .ply   | exact            | exact                   | exact           | forgotten             |
//
// Triangles keep their order and their first corner. All but STL weld corners that are equal in all
// they carry (in .dae and .glb within a part) and leave out positions that no triangle uses. -0 is
// written as 0. A part without a name, or a material, gets none; readers then make one up. Pictures
// are named, as the mesh names them (mesh/image/picture_names.h gives names that lead to them from elsewhere); those
// whose bytes it holds are part of a .glb and lie beside a .dae or .obj (mesh/image/embedded_pictures.h).
//
// assimp holds 32-bit numbers. Of a .dae it reads those that are such numbers exactly (from a
// millionth on), others within two units of the last place (among 396 real meshes).
//
// A .glb holds the coordinates as they are, without a node that would turn z up to the format's y
// up: Gazebo, and rigor's own reader, place glTF's x, y and z as a link's x, y and z. A viewer of
// glTF shows the model lying on its back. Its v runs down, and 1 - v is rounded once.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// A file that belongs beside another.
struct SideFile {
  std::string name;  ///< without a folder
  std::string bytes;
};

struct WrittenMesh {
  std::optional<std::string> bytes;
  std::string problem;                    ///< why there are no bytes
  std::vector<SideFile> side_files = {};  ///< which the bytes name: an .mtl, pictures
};

/// By the path's ending; nothing is written to a disk. There are no bytes for another ending, for
/// coordinates that are not finite or, in the 32-bit formats, over 3.4e38, for more triangles
/// than rigor reads (kMaxTriangles), and for a .glb over 4 GiB.
WrittenMesh write_mesh(const TriangleMesh& mesh, std::string_view path);

// What follows takes coordinates that the format can hold. A mesh without triangles gives a file
// that holds none. In names, tabs and line ends become spaces, what XML or UTF-8 does not allow
// U+FFFD.

std::string write_stl(const TriangleMesh& mesh);  ///< binary
/// `library` is the name of the .mtl, if there is one (mesh/obj/materials.h).
std::string write_obj(const TriangleMesh& mesh, const std::string& library = {});
std::string write_collada(const TriangleMesh& mesh);
std::string write_glb(const TriangleMesh& mesh);
std::string write_ply(const TriangleMesh& mesh);  ///< binary, little-endian

}  // namespace rigor::mesh
