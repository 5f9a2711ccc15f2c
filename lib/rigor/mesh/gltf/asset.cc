// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/mesh/asset/readers.h>
#include <rigor/mesh/gltf/json.h>
#include <rigor/mesh/gltf/ranges.h>
#include <rigor/mesh/line_counter.h>

namespace rigor::mesh {
namespace {

constexpr std::size_t kMaxExtensions = 100;

// A .glb is 12 bytes of header, then chunks: length, "JSON", the text (glTF 2.0, 4.4).
constexpr std::size_t kChunkOffset = 12;
constexpr std::size_t kTextOffset = 20;
constexpr std::uint32_t kChunkAlignment = 4;

/// Least byte first.
std::uint32_t u32_of_glb(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;)
    number = number << 8U | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

std::optional<std::string_view> json_of_glb(std::string_view bytes) {
  if (bytes.size() < kTextOffset || bytes.substr(kChunkOffset + 4, 4) != "JSON") {
    return std::nullopt;
  }
  return bytes.substr(kTextOffset, u32_of_glb(bytes, kChunkOffset));
}

/// Of the chunk behind the text of a .glb, which is its first buffer; nothing when there is none.
std::optional<std::uint64_t> binary_bytes_of_glb(std::string_view bytes, std::string_view json) {
  const std::size_t header = kTextOffset + json.size();
  if (bytes.size() < header + 8 || bytes.substr(header + 4, 4) != std::string_view("BIN\0", 4)) {
    return std::nullopt;
  }
  return std::min<std::uint64_t>(u32_of_glb(bytes, header), bytes.size() - header - 8);
}

/// How much a data: URI holds; nothing when it is not written in base64 (RFC 4648, 4).
std::optional<std::uint64_t> bytes_of_data_uri(std::string_view written) {
  constexpr std::string_view kBase64 = ";base64,";
  const std::size_t at = written.find(kBase64);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view data = written.substr(at + kBase64.size());
  const auto filling = std::count(data.begin(), data.end(), '=');  // at the end
  return (data.size() - static_cast<std::size_t>(filling)) * 3 / 4;
}

class GltfAssetReader {
 public:
  GltfAssetReader(const Disk& disk, const std::string& path) : disk_(disk), path_(path) {}

  /// The first buffer of a .glb has so many bytes.
  void hold(std::uint64_t bytes) { ranges_.hold(0, bytes); }

  /// Without lines in a .glb.
  Asset run(std::string_view json, std::optional<LineCounter> lines) {
    const bool whole = for_each_scalar(json, [&](const JsonScalar& scalar) {
      ranges_.take(scalar);
      if (scalar.kind == JsonScalar::Kind::kString) text(scalar, lines);
    });
    facts_.overruns = ranges_.overruns();
    facts_.nameless_buffers = ranges_.nameless();
    return {.problem = whole ? "" : "it is no well-formed JSON",
            .gltf = std::move(facts_),
            .textures = std::move(textures_)};
  }

 private:
  void text(const JsonScalar& scalar, std::optional<LineCounter>& lines) {
    if (scalar.section == "asset" && scalar.depth == 2) about(scalar.key, scalar.text);
    if (scalar.section == "extensionsRequired" && scalar.depth == 2 &&
        facts_.extensions_required.size() < kMaxExtensions) {
      facts_.extensions_required.emplace_back(scalar.text.substr(0, kMaxCopiedText));
    }
    if (!scalar.of_item() || scalar.key != "uri") return;
    if (scalar.section == "buffers") buffer(scalar, lines);
    if (scalar.section == "images") name(textures_, scalar, lines);
  }

  void about(std::string_view key, std::string_view text) {
    if (key == "version") facts_.version = text.substr(0, kMaxCopiedText);
    if (key == "generator") facts_.generator = text.substr(0, kMaxCopiedText);
  }

  void buffer(const JsonScalar& scalar, std::optional<LineCounter>& lines) {
    ranges_.name(scalar.item);
    if (!name(facts_.buffers, scalar, lines)) return;
    const FileReference& file = facts_.buffers.back();
    if (is_there(file)) ranges_.hold(scalar.item, file.bytes);
    if (file.state != FileReference::State::kEmbedded) return;
    if (const auto bytes = bytes_of_data_uri(scalar.text)) ranges_.hold(scalar.item, *bytes);
  }

  /// Whether there was room for it.
  bool name(std::vector<FileReference>& into, const JsonScalar& scalar,
            std::optional<LineCounter>& lines) const {
    if (into.size() == kMaxReferences) return false;
    into.push_back(
        resolve(disk_, path_, std::string(scalar.text), lines ? lines->at(scalar.end) : 0));
    return true;
  }

  const Disk& disk_;
  const std::string& path_;
  GltfFacts facts_;
  GltfRanges ranges_;
  std::vector<FileReference> textures_;
};

}  // namespace

Asset gltf_asset(const Disk& disk, const std::string& path, std::string_view bytes) {
  GltfAssetReader reader(disk, path);
  if (!bytes.starts_with("glTF")) return reader.run(bytes, LineCounter(bytes));
  const std::optional<std::string_view> json = json_of_glb(bytes);
  if (!json) return {.problem = "its first chunk is no JSON", .gltf = GltfFacts{}};
  if (const auto held = binary_bytes_of_glb(bytes, *json)) reader.hold(*held);
  Asset asset = reader.run(*json, std::nullopt);
  const std::uint32_t chunk = u32_of_glb(bytes, kChunkOffset);
  if (const std::uint32_t over = chunk % kChunkAlignment; over != 0) {
    const std::uint64_t filled_up = std::uint64_t{chunk} + (kChunkAlignment - over);
    asset.gltf->overruns = {1, GltfOverruns::Of::kChunk, 0, filled_up, chunk};
  }
  return asset;
}

}  // namespace rigor::mesh
