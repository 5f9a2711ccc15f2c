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
  report_mesh(file, context,
              "the Collada file says that " + std::string(collada->up_axis == Up::kX ? "X" : "Y") +
                  " points up, which some programs heed and some do not" +
                  in_line(collada->up_axis_line));
}

Rule rule() {
  return {
      .name = "mesh-up-axis",
      .severity = Severity::kInfo,
      .summary = "a Collada file says that another axis than Z points up",
      .why = "Gazebo and RViz pass over <up_axis> and take the coordinates as they are; assimp by "
             "itself, three.js and OpenSceneGraph turn the mesh. So it lies on its side in one of "
             "them.",
      .what_to_do = "Look at it in the simulator that counts. Where it stands upright, write it "
                    "anew, `rigor mesh-check FILE -o OUT.dae`: then Z is up for all. Where it "
                    "lies, add `--up y`, which turns it.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_up_axis
