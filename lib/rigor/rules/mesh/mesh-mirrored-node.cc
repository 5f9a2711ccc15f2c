// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_mirrored_node {

void check(const MeshFile& file, Context& context) {
  const auto& collada = file.facts.asset.collada;
  if (!collada || collada->mirrored_nodes.count == 0) return;
  const mesh::Sighting& mirrored = collada->mirrored_nodes;
  report_mesh(file, context,
              how_many(mirrored.count, "node") + in_line(mirrored.first) +
                  (mirrored.count == 1 ? " mirrors its" : " mirror their") +
                  " shapes: some readers then turn their triangles round, some do not");
}

Rule rule() {
  return {
      .name = "mesh-mirrored-node",
      .severity = Severity::kInfo,
      .summary = "a node of a mesh file mirrors its shapes",
      .why = "A transform with a negative scale turns the order of each triangle's corners around. "
             "Assimp leaves it to its user to turn it back. Exporters differ as well: some write a "
             "shape that is right only if nobody does. Where reader and exporter disagree, the "
             "inside of the part is drawn, and its volume is negative.",
      .what_to_do = "Apply the transforms before exporting, or write the mesh anew, which does so: "
                    "`rigor mesh-check FILE -o OUT.dae`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_mirrored_node
