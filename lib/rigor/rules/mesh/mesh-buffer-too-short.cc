// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_buffer_too_short {

std::string first_overrun(const mesh::GltfOverruns& overruns) {
  using Of = mesh::GltfOverruns::Of;
  const auto& [count, of, index, needed, held] = overruns;
  switch (of) {
    case Of::kBuffer: return fmt::format("buffer {} has {} bytes of {}", index, held, needed);
    case Of::kView:
      return fmt::format("buffer view {} reaches to byte {} of a buffer of {}", index, needed,
                         held);
    case Of::kAccessor:
      return fmt::format("accessor {} reaches to byte {} of a buffer view of {}", index, needed,
                         held);
    case Of::kChunk: break;  // has a rule of its own
  }
  return {};
}

void check(const MeshFile& file, Context& context) {
  const auto& gltf = file.facts.asset.gltf;
  if (!gltf || gltf->overruns.count == 0) return;
  const std::string first = first_overrun(gltf->overruns);
  if (first.empty()) return;
  const std::uint64_t more = gltf->overruns.count - 1;
  const std::string others = more == 0 ? "" : fmt::format(", and {} more are too short", more);
  report_mesh(file, context, first + others);
}

Rule rule() {
  return {
      .name = "mesh-buffer-too-short",
      .severity = Severity::kError,
      .summary = "a glTF file names more bytes than there are",
      .why = "Accessors lie in buffer views, and those in buffers. Of one that reaches beyond its "
             "end assimp reads nothing and refuses the whole mesh: \"out of range\". Mostly the "
             "file was cut when it was copied, or its buffer is of another export.",
      .what_to_do = "Copy the mesh and its buffers again, or export it anew.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_buffer_too_short
