// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/mesh/gltf.h>
#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_buffer_missing {

// Of collisions, too: without its buffers a file has no shape.
void check(const MeshFile& file, Context& context) {
  report_references(file, context, missing_buffers(file), "the file of a buffer is not found",
                    "files of buffers are not found");
  const mesh::Sighting nameless = nameless_buffers(file);
  if (nameless.count == 0) return;
  const std::string first = std::to_string(nameless.first - 1);
  report_mesh(file, context,
              nameless.count == 1
                  ? "buffer " + first + " names no file that has its bytes"
                  : std::to_string(nameless.count) +
                        " buffers name no file that has their bytes, the first is buffer " + first);
}

Rule rule() {
  return {
      .name = "mesh-buffer-missing",
      .severity = Severity::kError,
      .summary = "a buffer of a glTF file is not found",
      .why = "Assimp rejects the whole mesh when one of its files is missing, and so do Gazebo and "
             "RViz, which use it. A .gltf describes the scene; its vertices and triangles are in "
             "files beside it.",
      .what_to_do = "Put the file, mostly a .bin, where the .gltf refers to it, or export the mesh "
                    "as .glb, which is one file.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_buffer_missing
