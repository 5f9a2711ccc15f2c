// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rules on glTF files share: which extensions a file needs, which of its buffers are missing,
// and whether that is why it cannot be read.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mass/mesh/facts.h>
#include <rigor/mesh/asset/asset.h>
#include <rigor/rules/rule.h>

namespace rigor::rules {

/// Extensions that say what the shape is, and that assimp 5.2.5 ignores.
inline constexpr std::array<std::string_view, 4> kShapeExtensions{
    "KHR_mesh_quantization", "EXT_meshopt_compression", "KHR_meshopt_compression",
    "EXT_mesh_gpu_instancing"};

/// Those of the list that a glTF file requires, as references, so that they can be listed as such.
template <std::size_t kCount>
std::vector<mesh::FileReference> required_of(
    const MeshFile& file, const std::array<std::string_view, kCount>& extensions) {
  std::vector<mesh::FileReference> found;
  const std::optional<mesh::GltfFacts>& gltf = file.facts.asset.gltf;
  if (!gltf) return found;
  for (const std::string& name : gltf->extensions_required) {
    const bool listed = std::find(extensions.begin(), extensions.end(), name) != extensions.end();
    if (listed) found.push_back({.written = name});
  }
  return found;
}

/// Buffers whose file no reader finds.
inline std::vector<mesh::FileReference> missing_buffers(const MeshFile& file) {
  using State = mesh::FileReference::State;
  std::vector<mesh::FileReference> missing;
  const std::optional<mesh::GltfFacts>& gltf = file.facts.asset.gltf;
  if (!gltf) return missing;
  for (const mesh::FileReference& buffer : gltf->buffers) {
    const State state = buffer.state;
    if (state == State::kMissing || state == State::kWrongCase || state == State::kBackslash ||
        state == State::kTextures || state == State::kUrl) {
      missing.push_back(buffer);
    }
  }
  return missing;
}

/// Buffers that name no file. Where an extension is to fill them, that is reported instead.
inline mesh::Sighting nameless_buffers(const MeshFile& file) {
  const std::optional<mesh::GltfFacts>& gltf = file.facts.asset.gltf;
  if (!gltf || !required_of(file, kShapeExtensions).empty()) return {};
  return gltf->nameless_buffers;
}

/// Whether a rule on glTF says why the file cannot be read.
inline bool gltf_explains(const MeshFile& file) {
  const std::optional<mesh::GltfFacts>& gltf = file.facts.asset.gltf;
  return gltf && (gltf->overruns.count > 0 || gltf->nameless_buffers.count > 0 ||
                  !missing_buffers(file).empty() || !required_of(file, kShapeExtensions).empty());
}

}  // namespace rigor::rules
