// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_material_undefined {

void check(const MeshFile& file, Context& context) {
  if (!is_drawn(file)) return;
  References undefined;
  for (const mesh::Mention& material : file.facts.asset.undefined_materials) {
    undefined.push_back({.written = material.name, .line = material.line});
  }
  report_references(file, context, undefined, "a material is not defined",
                    "materials are not defined");
}

Rule rule() {
  return {
      .name = "mesh-material-undefined",
      .severity = Severity::kWarning,
      .summary = "triangles of a mesh have a material that no file defines",
      .why = "They are drawn in the colour that a program has for what it knows nothing of, mostly "
             "grey. In an OBJ a material is defined (newmtl) by the library that mtllib names; the "
             "triangles of a Collada file have a symbol, which an instance of their geometry binds "
             "to a material.",
      .what_to_do =
          "Define the material, name the library that does, or export the mesh with its materials.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_material_undefined
