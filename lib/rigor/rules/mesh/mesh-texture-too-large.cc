// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>

#include <fmt/core.h>

#include <rigor/rules/mesh/texture.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_texture_too_large {

// What GPUs have been able to hold for fifteen years; more also takes 85 MB and up.
constexpr std::uint32_t kLargest = 4096;  // pixels

void check(const MeshFile& file, Context& context) {
  if (!is_drawn(file)) return;
  References large;
  for (const mesh::FileReference& texture :
       in_state(file.facts.asset.textures, mesh::FileReference::State::kFound)) {
    if (std::max(texture.width, texture.height) > kLargest) large.push_back(texture);
  }
  if (large.empty()) return;
  report_references(file, context, large,
                    fmt::format("a texture has {} × {} pixels, over 4096", large.front().width,
                                large.front().height),
                    "textures have more than 4096 pixels in a row");
}

Rule rule() {
  return {
      .name = "mesh-texture-too-large",
      .severity = Severity::kInfo,
      .summary = "a texture has more than 4096 pixels in a row",
      .why = "It takes 85 MB and more of a graphics card's memory once it is unpacked, also in "
             "each simulated camera; older cards and drivers refuse it or draw white.",
      .what_to_do = "Scale the picture down: `convert big.png -resize 2048x2048 small.png`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_texture_too_large
