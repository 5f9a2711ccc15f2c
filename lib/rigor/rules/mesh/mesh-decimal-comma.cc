// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_decimal_comma {

void check(const MeshFile& file, Context& context) {
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kDecimalComma);
  if (fault == nullptr) return;
  report_mesh(file, context,
              how_many(fault->count, "number") + (fault->count == 1 ? " is" : " are") +
                  " written with a decimal comma" + in_line(fault->line));
}

Rule rule() {
  return {
      .name = "mesh-decimal-comma",
      .severity = Severity::kWarning,
      .summary = "numbers in a mesh have a decimal comma",
      .why = "Most readers, admesh among them, reject the file or drop the digits after the comma; "
             "assimp reads it as meant. The file was written by a program in a language that "
             "writes 1,5 for 1.5.",
      .what_to_do = "Write the file again: `rigor mesh-check FILE -o OUT.stl`; better, set the "
                    "exporter to English.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_decimal_comma
