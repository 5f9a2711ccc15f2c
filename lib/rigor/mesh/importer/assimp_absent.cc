// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is compiled in place of the importer without assimp (RIGOR_WITH_ASSIMP=OFF).

#include <rigor/mesh/importer/assimp.h>

namespace rigor::mesh {

LoadedMesh import_with_assimp(const Disk&, const std::string&, std::string_view) {
  return {.faults = {{FaultKind::kImporterMissing, assimp_version()}}};
}

std::string assimp_version() { return "rigor was built without assimp"; }

}  // namespace rigor::mesh
