// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/gltf/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace rigor::mesh {
namespace {

// Scenes of cities have some ten thousand; a file must not make us keep more than it is worth.
constexpr std::uint64_t kMaxGltfItems = 1'000'000;

// Numbers are cut to these, so that no product of them overflows. A file has 2^31 bytes at most, and
// a stride 252 (glTF 2.0, 3.6.2.4).
constexpr double kMaxGltfBytes = 1e12;
constexpr std::uint64_t kMaxGltfStride = 1 << 20U;

template <class Item>
Item* gltf_item(std::vector<Item>& items, std::uint64_t index) {
  if (index >= kMaxGltfItems) return nullptr;
  if (index >= items.size()) items.resize(static_cast<std::size_t>(index) + 1);
  return &items[static_cast<std::size_t>(index)];
}

template <class Item>
const Item* find_gltf_item(const std::vector<Item>& items, std::optional<std::uint64_t> index) {
  return index && *index < items.size() ? &items[static_cast<std::size_t>(*index)] : nullptr;
}

/// Zero of what is below, and of what is no number.
std::uint64_t gltf_number(double value) {
  return value > 0 ? static_cast<std::uint64_t>(std::floor(std::min(value, kMaxGltfBytes))) : 0;
}

std::uint64_t gltf_component_bytes(std::uint64_t type) {
  constexpr std::uint64_t kByte = 5120;
  constexpr std::array<std::uint64_t, 7> kBytes{1, 1, 2, 2, 0, 4, 4};
  return type >= kByte && type - kByte < kBytes.size() ? kBytes[type - kByte] : 0;
}

/// Of small matrices the bytes that pad their columns are not counted.
std::uint64_t gltf_components(std::string_view type) {
  struct Type {
    std::string_view name;
    std::uint64_t components;
  };
  constexpr std::array<Type, 7> kTypes{{{"SCALAR", 1},
                                        {"VEC2", 2},
                                        {"VEC3", 3},
                                        {"VEC4", 4},
                                        {"MAT2", 4},
                                        {"MAT3", 9},
                                        {"MAT4", 16}}};
  const auto* const found =
      std::find_if(kTypes.begin(), kTypes.end(), [&](const Type& t) { return t.name == type; });
  return found == kTypes.end() ? 0 : found->components;
}

}  // namespace

void GltfRanges::take(const JsonScalar& scalar) {
  if (!scalar.of_item()) return;
  const auto take_in = [&](auto& items) {
    if (auto* const item = gltf_item(items, scalar.item)) take(*item, scalar);
  };
  if (scalar.section == "buffers") take_in(buffers_);
  if (scalar.section == "bufferViews") take_in(views_);
  if (scalar.section == "accessors") take_in(accessors_);
}

void GltfRanges::take(Buffer& buffer, const JsonScalar& scalar) const {
  if (scalar.key == "byteLength") buffer.promised = gltf_number(scalar.number);
}

void GltfRanges::take(View& view, const JsonScalar& scalar) const {
  const std::uint64_t number = gltf_number(scalar.number);
  if (scalar.key == "buffer") view.buffer = number;
  if (scalar.key == "byteOffset") view.offset = number;
  if (scalar.key == "byteLength") view.length = number;
  if (scalar.key == "byteStride") view.stride = std::min(number, kMaxGltfStride);
}

void GltfRanges::take(Accessor& accessor, const JsonScalar& scalar) const {
  if (scalar.key == "type") accessor.width = gltf_components(scalar.text);
  const std::uint64_t number = gltf_number(scalar.number);
  if (scalar.key == "bufferView") accessor.view = number;
  if (scalar.key == "byteOffset") accessor.offset = number;
  if (scalar.key == "count") accessor.count = number;
  if (scalar.key == "componentType") accessor.component = gltf_component_bytes(number);
}

void GltfRanges::hold(std::uint64_t buffer, std::uint64_t bytes) {
  if (Buffer* const item = gltf_item(buffers_, buffer)) item->held = bytes;
}

void GltfRanges::name(std::uint64_t buffer) {
  if (Buffer* const item = gltf_item(buffers_, buffer)) item->named = true;
}

std::uint64_t GltfRanges::end_of(const Accessor& accessor, const View& view) {
  const std::uint64_t size = accessor.component * accessor.width;
  if (size == 0 || accessor.count == 0) return 0;
  const std::uint64_t stride = view.stride > 0 ? view.stride : size;
  return accessor.offset + (accessor.count - 1) * stride + size;
}

GltfOverruns GltfRanges::overruns() const {
  using Of = GltfOverruns::Of;
  GltfOverruns overruns;
  const auto compare = [&](Of of, std::size_t index, std::uint64_t needed, std::uint64_t held) {
    if (needed <= held) return;
    if (overruns.count++ == 0) overruns = {1, of, index, needed, held};
  };
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    const Buffer& buffer = buffers_[i];
    if (buffer.held) compare(Of::kBuffer, i, buffer.promised, *buffer.held);
  }
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const Buffer* const buffer = find_gltf_item(buffers_, views_[i].buffer);
    if (buffer) compare(Of::kView, i, views_[i].offset + views_[i].length, buffer->promised);
  }
  for (std::size_t i = 0; i < accessors_.size(); ++i) {
    const View* const view = find_gltf_item(views_, accessors_[i].view);
    if (view) compare(Of::kAccessor, i, end_of(accessors_[i], *view), view->length);
  }
  return overruns;
}

Sighting GltfRanges::nameless() const {
  Sighting nameless;
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    const Buffer& buffer = buffers_[i];
    if (buffer.promised > 0 && !buffer.held && !buffer.named) nameless.add(i + 1);
  }
  return nameless;
}

}  // namespace rigor::mesh
