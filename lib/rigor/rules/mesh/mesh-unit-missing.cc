// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_unit_missing {

void check(const MeshFile& file, Context& context) {
  const auto& collada = file.facts.asset.collada;
  if (!collada || collada->unit_line > 0) return;
  report_mesh(file, context, "the Collada file names no unit: its lengths are taken for metres");
}

Rule rule() {
  return {
      .name = "mesh-unit-missing",
      .severity = Severity::kInfo,
      .summary = "a Collada file names no unit",
      .why = "Without a <unit> its lengths are metres, by Collada's definition. Whether they were "
             "meant so nobody can tell: a third of the Collada files of some robots has none.",
      .what_to_do = "Look at the size, and say what a unit is: `rigor mesh-check FILE --unit mm -o "
                    "OUT.dae` writes metres and says so.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_unit_missing
