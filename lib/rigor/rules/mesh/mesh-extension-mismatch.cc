// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>
#include <rigor/text/path.h>

namespace rigor::rules::mesh_extension_mismatch {

void check(const MeshFile& file, Context& context) {
  const mesh::Fault* fault = fault_of(file, mesh::FaultKind::kExtensionMismatch);
  if (fault == nullptr) return;
  report_mesh(file, context,
              "the file holds a mesh in the format " + fault->detail + ", its ending is " +
                  extension(file.facts.path));
}

Rule rule() {
  return {
      .name = "mesh-extension-mismatch",
      .severity = Severity::kWarning,
      .summary = "a mesh file has the ending of another format",
      .why = "Many readers choose by the ending and then fail, or read nonsense; assimp sees "
             "through some of it.",
      .what_to_do = "Give the file the ending of its format, here and where it is used; or convert "
                    "it: `rigor mesh-check FILE -o OUT.stl`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_extension_mismatch
