// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_lfs_pointer {

void check(const MeshFile& file, Context& context) {
  if (fault_of(file, mesh::FaultKind::kLfsPointer) == nullptr) return;
  report_mesh(file, context, "in place of the mesh stands a pointer of Git LFS");
}

Rule rule() {
  return {
      .name = "mesh-lfs-pointer",
      .severity = Severity::kError,
      .summary = "a Git LFS pointer stands in place of a mesh",
      .why = "The repository was cloned without Git LFS, so that three lines of text stand where "
             "the mesh belongs. No reader takes them for a mesh.",
      .what_to_do = "Install git-lfs and run `git lfs pull` in the repository.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_lfs_pointer
