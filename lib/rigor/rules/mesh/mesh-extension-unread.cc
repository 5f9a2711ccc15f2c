// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/gltf.h>
#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_extension_unread {

// Of collisions, too: it is the shape that is not understood.
void check(const MeshFile& file, Context& context) {
  report_references(file, context, required_of(file, kShapeExtensions),
                    "the mesh needs an extension of glTF that simulators do not know",
                    "extensions of glTF that simulators do not know are needed");
}

Rule rule() {
  return {
      .name = "mesh-extension-unread",
      .severity = Severity::kError,
      .summary = "a glTF file needs an extension for its shape that simulators do not know",
      .why = "Gazebo and RViz read glTF by assimp, which does not look at what a file requires. Of "
             "points in whole numbers (KHR_mesh_quantization) assimp 5.2.5 takes the bytes for "
             "floating-point numbers: the shape is rubbish, and nothing is said. Points that "
             "meshoptimizer packed (EXT_meshopt_compression) it refuses, and of instances "
             "(EXT_mesh_gpu_instancing) it shows one. What rigor says of such a shape means "
             "nothing either.",
      .what_to_do = "Export the mesh without it; gltfpack leaves it out with -noq and without -c.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_extension_unread
