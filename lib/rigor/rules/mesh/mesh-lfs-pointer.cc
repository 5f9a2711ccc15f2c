// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_lfs_pointer {
namespace {

void check(const MeshFile& file, Context& context) {
  if (fault_of(file, mesh::FaultKind::kLfsPointer) == nullptr) return;
  report_mesh(file, context, "in place of the mesh stands a pointer of Git LFS");
}

}  // namespace

Rule rule() {
  return {
      .name = "mesh-lfs-pointer",
      .category = Category::kMesh,
      .severity = Severity::kError,
      .summary = "a Git LFS pointer stands in place of a mesh",
      .why =
          "The repository was cloned without Git LFS, so that three lines of text stand where "
          "the mesh belongs. No reader takes them for a mesh.",
      .what_to_do = "Install git-lfs and run `git lfs pull` in the repository.",
      .bad = {{R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <visual name="shell">
        <geometry><mesh><uri>«meshes/shell.stl»</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/shell.stl
version https://git-lfs.github.com/spec/v1
oid sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393
size 12345
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="part">
    <static>true</static>
    <link name="body">
      <visual name="shell">
        <geometry><mesh><uri>meshes/shell.obj</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
=== meshes/shell.obj
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
)"}},
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_lfs_pointer
