// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_malformed {

/// The importer ends its sentences as it likes.
std::string reason(const mesh::Fault& fault) {
  return fault.detail.substr(0, fault.detail.find_last_not_of(" .\r\n") + 1);
}

std::string message(const mesh::Fault& fault) {
  switch (fault.kind) {
    case mesh::FaultKind::kUnreadable: return "the mesh file cannot be opened: " + reason(fault);
    case mesh::FaultKind::kImporterCrashed:
      return "the mesh cannot be read: assimp " + reason(fault);
    default: return "the mesh cannot be read: " + reason(fault) + in_line(fault.line);
  }
}

void check(const MeshFile& file, Context& context) {
  using Kind = mesh::FaultKind;
  for (const Kind kind : {Kind::kMalformed, Kind::kImporterCrashed, Kind::kUnreadable}) {
    const mesh::Fault* fault = fault_of(file, kind);
    if (fault != nullptr) return report_mesh_text(file, context, message(*fault));
  }
}

Rule rule() {
  return {
      .name = "mesh-malformed",
      .severity = Severity::kError,
      .summary = "mesh file is malformed",
      .why = "The file is damaged, or is something else than a mesh. Simulators leave the shape "
             "out: a visual cannot be seen, a collision is passed through. Some readers crash on "
             "such files: of 764 damaged ones, assimp 5.2.5 crashed or ran away on 17.",
      .what_to_do = "Export the mesh again. The message names what could not be parsed.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_malformed
