// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_up_axis {

void check(const MeshFile& file, Context& context) {
  using Up = mesh::ColladaFacts::Up;
  const auto& collada = file.facts.asset.collada;
  if (!collada || (collada->up_axis != Up::kX && collada->up_axis != Up::kY)) return;
  report_mesh(
      file, context,
      "the Collada file declares that " + std::string(collada->up_axis == Up::kX ? "X" : "Y") +
          " points up, which some programs heed and some do not" + in_line(collada->up_axis_line));
}

Rule rule() {
  return {
      .name = "mesh-up-axis",
      .severity = Severity::kInfo,
      .summary = "Collada up_axis is not Z",
      .why =
          "Gazebo and RViz ignore <up_axis> and use the coordinates as they are; assimp by itself, "
          "three.js and OpenSceneGraph rotate the mesh. So it is on its side in one of them.",
      .what_to_do = "Check it in your simulator. Where it is upright, write it again, `rigor "
                    "mesh-check FILE -o OUT.dae`: then Z is up for all. Where it is on its side, "
                    "add `--up y`, which rotates it.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_up_axis
