// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_material_library_missing {

void check(const MeshFile& file, Context& context) {
  using State = mesh::FileReference::State;
  const auto& obj = file.facts.asset.obj;
  if (!obj || !is_drawn(file)) return;
  References missing;
  for (const State state : {State::kMissing, State::kWrongCase, State::kBackslash}) {
    const References found = in_state(obj->libraries, state);
    missing.insert(missing.end(), found.begin(), found.end());
  }
  report_references(file, context, missing, "the library of materials is not found",
                    "libraries of materials are not found");
}

Rule rule() {
  return {
      .name = "mesh-material-library-missing",
      .severity = Severity::kWarning,
      .summary = "the library of materials of an OBJ is not found",
      .why = "The .mtl file that mtllib names holds the colours and textures. Without it the part "
             "is drawn in one colour.",
      .what_to_do = "Put the .mtl file beside the .obj, under the name that mtllib says.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_material_library_missing
