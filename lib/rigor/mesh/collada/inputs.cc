// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collada/inputs.h>

#include <algorithm>
#include <limits>

#include <rigor/mesh/read.h>

namespace rigor::mesh {
namespace {

std::size_t kind_of_semantic(std::string_view semantic) {
  if (semantic == "VERTEX" || semantic == "POSITION") return kColladaPosition;
  if (semantic == "TEXCOORD") return kColladaTexture;
  if (semantic == "NORMAL") return kColladaNormal;
  return semantic == "COLOR" ? kColladaColor : kColladaKinds;
}

}  // namespace

ColladaInputs collada_inputs(xml::Element holder) {
  ColladaInputs inputs;
  std::array<std::uint64_t, kColladaKinds> sets;
  sets.fill(std::numeric_limits<std::uint64_t>::max());
  for (const xml::Element input : holder.children()) {
    if (input.name() != "input") continue;
    const std::uint64_t offset = count_of(input, "offset").value_or(0);
    // More inputs than numbers in the longest text: the <p> then ends inside its first corner.
    inputs.stride = std::max(inputs.stride, std::min<std::uint64_t>(offset, kMaxMeshBytes) + 1);
    const std::size_t kind = kind_of_semantic(value(input, "semantic"));
    if (kind == kColladaKinds) continue;
    const std::uint64_t set = count_of(input, "set").value_or(0);
    if (set >= sets[kind]) continue;
    sets[kind] = set;
    inputs.of[kind] = {value(input, "source"), offset};
  }
  return inputs;
}

std::optional<ColladaCorner> ColladaCornerReader::next() {
  ColladaCorner corner;
  corner.fill(kNoColladaIndex);
  for (std::uint64_t i = 0; i < inputs_.stride; ++i) {
    cursor_.skip_space();
    if (i == 0 && cursor_.at_end()) return std::nullopt;
    const std::optional<std::int64_t> index = cursor_.whole_number();
    if (!index) {
      failed_ = true;
      return std::nullopt;
    }
    if (*index < 0 || *index >= std::int64_t{kNoColladaIndex}) continue;
    for (std::size_t kind = 0; kind < kColladaKinds; ++kind) {
      if (inputs_.of[kind].offset == i) corner[kind] = static_cast<std::uint32_t>(*index);
    }
  }
  return corner;
}

}  // namespace rigor::mesh
