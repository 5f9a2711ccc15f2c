// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_16_bit_indices {

constexpr std::uint64_t kMax = 65'535;

void check(const MeshFile& file, Context& context) {
  if (file.collision() || file.facts.largest_part <= kMax) return;
  report_mesh(
      file, context,
      fmt::format("a part of the mesh has {} vertices, over {}", file.facts.largest_part, kMax));
}

Rule rule() {
  return {
      .name = "mesh-16-bit-indices",
      .severity = Severity::kInfo,
      .summary = "a part of a mesh has more than 65 535 vertices",
      .why = "Older versions of Ogre, rviz and Irrlicht draw such a part wrong or not at all. "
             "Indices of 16 bits do not reach the others.",
      .what_to_do = "Reduce it, `rigor mesh-check FILE --reduce 20000 -o OUT`, or split it into "
                    "several parts.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_16_bit_indices
