// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_glb_misaligned {

void check(const MeshFile& file, Context& context) {
  const auto& gltf = file.facts.asset.gltf;
  if (!gltf || gltf->overruns.of != mesh::GltfOverruns::Of::kChunk) return;
  report_mesh(file, context,
              fmt::format("the first chunk of the .glb has {} bytes, and is not filled up to {}",
                          gltf->overruns.held, gltf->overruns.needed));
}

Rule rule() {
  return {
      .name = "mesh-glb-misaligned",
      .severity = Severity::kError,
      .summary = "a chunk of a .glb does not end where one may",
      .why = "Chunks are filled up with blanks or zeros to four bytes, and assimp looks for the "
             "next one there. Of a file that is not filled up it says that it has \"no suitable "
             "reader\". Found in 2 of 31 real files, which trimesh wrote.",
      .what_to_do = "Write the mesh anew, with a newer version of what wrote it.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_glb_misaligned
