// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/stl/stl.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

#include <rigor/mesh/stl/ascii.h>
#include <rigor/mesh/text_cursor.h>

namespace rigor::mesh {
namespace {

constexpr std::size_t kCountOffset = 80;
constexpr std::size_t kNormalBytes = 12;

/// Little-endian on any machine.
std::uint32_t u32(const char* bytes) {
  const auto byte = [bytes](int i) {
    return std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  };
  return byte(0) | byte(1) | byte(2) | byte(3);
}

Vector3 corner(const char* bytes) {
  const auto at = [bytes](int i) { return double{std::bit_cast<float>(u32(bytes + 4 * i))}; };
  return {at(0), at(1), at(2)};
}

/// Whether it is text, with an odd byte here and there, where a binary file has its count and first
/// facets: of their bytes about half are odd. What is before may be text in both.
bool is_text(std::string_view first_bytes) {
  const std::string_view body = first_bytes.substr(std::min(kCountOffset, first_bytes.size()));
  const auto odd = std::count_if(body.begin(), body.end(),
                                 [](char c) { return (c < ' ' && !is_space(c)) || c > '~'; });
  return static_cast<std::size_t>(odd) * 4 <= body.size();
}

/// What header and size say. `first_bytes` are 512 or all.
std::vector<Fault> frame_faults(std::string_view first_bytes, std::uint64_t size) {
  if (size < kStlHeaderBytes) {
    return {{FaultKind::kMalformed, "a binary STL has 84 bytes at least"}};
  }
  if (!stl_size_fits(first_bytes, size) && is_text(first_bytes)) {
    return {{FaultKind::kMalformed, "it is neither a binary STL nor text that begins with solid"}};
  }
  const std::uint64_t promised = u32(first_bytes.data() + kCountOffset);
  const std::uint64_t held = stl_triangles(first_bytes, size);
  const std::uint64_t used = kStlHeaderBytes + held * kStlFacetBytes;
  std::vector<Fault> faults;
  if (held == 0) faults.push_back({FaultKind::kEmpty});
  if (held > kMaxTriangles) faults.push_back({FaultKind::kTooLarge});
  if (held < promised) faults.push_back({FaultKind::kTruncated, {}, promised - held});
  if (held == promised && used < size) {
    faults.push_back({FaultKind::kTrailingBytes, {}, size - used});
  }
  if (first_bytes.starts_with("solid")) faults.push_back({FaultKind::kSolidHeader});
  return faults;
}

TriangleMesh mesh_for(std::size_t count) {
  TriangleMesh mesh;
  mesh.positions.reserve(3 * count);
  mesh.triangles.reserve(count);
  mesh.parts = {{{}, {}, 0, count}};
  return mesh;
}

/// The facets whose bytes these are.
void append_facets(std::string_view bytes, TriangleMesh& mesh) {
  for (std::size_t at = 0; at < bytes.size(); at += kStlFacetBytes) {
    const Facet corners = stl_facet(bytes.data() + at);
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({base, base + 1, base + 2});
  }
}

/// In `first`, which facet is the first.
Tally not_finite(const std::vector<Vector3>& positions) {
  Tally bad;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vector3& p = positions[i];
    for (const double coordinate : {p.x, p.y, p.z}) {
      if (!std::isfinite(coordinate)) bad.add(i / 3);
    }
  }
  return bad;
}

LoadedMesh finished(LoadedMesh loaded) {
  const Tally bad = not_finite(loaded.mesh.positions);
  if (bad.count == 0) return loaded;
  loaded.mesh = {};
  loaded.faults.push_back(
      {FaultKind::kNotFinite, "facet " + std::to_string(bad.first + 1), bad.count});
  return loaded;
}

LoadedMesh read_binary_stl(std::string_view bytes) {
  LoadedMesh loaded{.format = Format::kStlBinary,
                    .faults = frame_faults(bytes.substr(0, kProbeBytes), bytes.size())};
  if (!loaded.usable()) return loaded;
  const auto count = static_cast<std::size_t>(stl_triangles(bytes, bytes.size()));
  loaded.mesh = mesh_for(count);
  append_facets(bytes.substr(kStlHeaderBytes, count * kStlFacetBytes), loaded.mesh);
  return finished(std::move(loaded));
}

}  // namespace

bool stl_size_fits(std::string_view first_bytes, std::uint64_t size) {
  if (first_bytes.size() < kStlHeaderBytes) return false;
  const std::uint64_t count = u32(first_bytes.data() + kCountOffset);
  return size == kStlHeaderBytes + count * kStlFacetBytes;
}

bool is_binary_stl(std::string_view first_bytes, std::uint64_t size) {
  if (stl_size_fits(first_bytes, size)) return true;
  return !is_text(first_bytes) || !TextCursor(first_bytes).sees("solid");
}

std::uint64_t stl_triangles(std::string_view header, std::uint64_t size) {
  if (header.size() < kStlHeaderBytes || size < kStlHeaderBytes) return 0;
  return std::min<std::uint64_t>(u32(header.data() + kCountOffset),
                                 (size - kStlHeaderBytes) / kStlFacetBytes);
}

Facet stl_facet(const char* bytes) {
  const char* const corners = bytes + kNormalBytes;
  return {corner(corners), corner(corners + 12), corner(corners + 24)};
}

std::optional<LoadedMesh> read_plain_stl(const OpenFile& file) {
  constexpr std::size_t kBlock = 20'000 * kStlFacetBytes;  // a megabyte
  std::string block(kProbeBytes, '\0');
  block.resize(file.read(0, block.data(), block.size()));
  if (!stl_size_fits(block, file.size())) return std::nullopt;
  LoadedMesh loaded{.format = Format::kStlBinary, .faults = frame_faults(block, file.size())};
  if (!loaded.usable()) return loaded;
  loaded.mesh = mesh_for(static_cast<std::size_t>(stl_triangles(block, file.size())));
  for (std::uint64_t at = kStlHeaderBytes; at < file.size(); at += block.size()) {
    block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, file.size() - at)));
    if (file.read(at, block.data(), block.size()) < block.size()) return std::nullopt;
    append_facets(block, loaded.mesh);
  }
  return finished(std::move(loaded));
}

LoadedMesh read_stl(std::string_view bytes) {
  if (bytes.empty()) return {.faults = {{FaultKind::kEmpty}}};
  const bool binary = is_binary_stl(bytes.substr(0, kProbeBytes), bytes.size());
  return binary ? read_binary_stl(bytes) : read_ascii_stl(bytes);
}

}  // namespace rigor::mesh
