// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_mujoco_faces {

constexpr std::uint64_t kMax = 200'000;

void check(const MeshFile& file, Context& context) {
  const bool stl =
      file.facts.format == mesh::Format::kStlBinary || file.facts.format == mesh::Format::kStlAscii;
  if (!stl || file.facts.triangles <= kMax) return;
  report_mesh(file, context,
              fmt::format("the STL has {} triangles, and MuJoCo reads {} at most",
                          file.facts.triangles, kMax));
}

Rule rule() {
  return {
      .name = "mesh-mujoco-faces",
      .severity = Severity::kInfo,
      .summary = "an STL has more triangles than MuJoCo reads",
      .why = "MuJoCo rejects an STL with more than 200 000 facets.",
      .what_to_do = "Reduce it: `rigor mesh-check FILE --reduce 50000 -o OUT`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_mujoco_faces
