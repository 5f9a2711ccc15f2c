// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_lfs_pointer {

void check(const MeshFile& file, Context& context) {
  if (fault_of(file, mesh::FaultKind::kLfsPointer) == nullptr) return;
  report_mesh(file, context, "the file is a Git LFS pointer, not a mesh");
}

Rule rule() {
  return {
      .name = "mesh-lfs-pointer",
      .severity = Severity::kError,
      .summary = "a mesh file is a Git LFS pointer",
      .why = "The repository was cloned without Git LFS, so that the file has three lines of text "
             "instead of the mesh. All readers reject it.",
      .what_to_do = "Install git-lfs and run `git lfs pull` in the repository.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_lfs_pointer
