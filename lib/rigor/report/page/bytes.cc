// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/page/bytes.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <new>
#include <string_view>
#include <vector>

#include <rigor/text/base64.h>

namespace rigor::report {
namespace {

using mesh::Vector3;

constexpr double kLargest16 = 65535;
constexpr std::size_t kMaxShortIndices = 65535;

/// Between size and speed: level 9 takes three times as long for a hundredth of the bytes.
constexpr int kPageCompression = 6;

/// All that a vertex is: three positions, three normals and a zero, a place in a picture, a color.
constexpr std::size_t kVertexBytes = 22;
using PackedVertex = std::array<char, kVertexBytes>;
constexpr std::size_t kNormalAt = 6;
constexpr std::size_t kTextureAt = 10;
constexpr std::size_t kColorAt = 18;

template <std::size_t kBytes>
void put(char* to, std::uint32_t number) {
  for (std::size_t i = 0; i < kBytes; ++i) to[i] = static_cast<char>((number >> (8 * i)) & 255U);
}

/// Numbers of a file may be anything.
double within(double value, double low, double high) {
  return std::isfinite(value) ? std::clamp(value, low, high) : 0;
}

std::uint32_t quantized(double value, double low, double step) {
  return static_cast<std::uint32_t>(
      step > 0 ? within(std::round((value - low) / step), 0, kLargest16) : 0);
}

/// Finds vertices that are the same: a table of indices with open addressing, in which a mesh of six
/// million corners is looked up in a second.
class VertexTable {
 public:
  explicit VertexTable(std::size_t corners)
      : slots_(std::bit_ceil(std::max<std::size_t>(16, corners + corners / 2)), kFree) {}

  std::uint32_t index_of(const PackedVertex& vertex) {
    std::uint64_t hash = 0xcbf29ce484222325U;  // FNV-1a
    for (const char byte : vertex) hash = (hash ^ static_cast<std::uint8_t>(byte)) * 0x100000001b3U;
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = (hash ^ (hash >> 32U)) & mask;; at = (at + 1) & mask) {
      if (slots_[at] == kFree) {
        slots_[at] = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(vertex);
        return slots_[at];
      }
      if (vertices_[slots_[at]] == vertex) return slots_[at];
    }
  }

  const std::vector<PackedVertex>& vertices() const { return vertices_; }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffU;
  std::vector<std::uint32_t> slots_;
  std::vector<PackedVertex> vertices_;
};

class CornerPacker {
 public:
  CornerPacker(const mesh::TriangleMesh& mesh, Textured textured)
      : mesh_(mesh), textured_(textured == Textured::kYes && !mesh.corners.texture.empty()) {
    const mesh::Bounds bounds = mesh::bounds_of(mesh.positions);
    if (mesh.positions.empty()) return;
    low = bounds.min;
    step = (1 / kLargest16) * (bounds.max - bounds.min);
  }

  PackedVertex corner(std::size_t triangle, std::size_t k) const {
    PackedVertex out{};
    const Vector3& p = mesh_.positions[mesh_.triangles[triangle][k]];
    put<2>(&out[0], quantized(p.x, low.x, step.x));
    put<2>(&out[2], quantized(p.y, low.y, step.y));
    put<2>(&out[4], quantized(p.z, low.z, step.z));
    const mesh::Corners& corners = mesh_.corners;
    for (std::size_t i = 0; i < 3 && !corners.normals.empty(); ++i) {
      const double of_127 = std::round(127 * within(corners.normals[triangle][k][i], -1, 1));
      put<1>(&out[kNormalAt + i], static_cast<std::uint32_t>(static_cast<int>(of_127)));
    }
    for (std::size_t i = 0; i < 2 && textured_; ++i) {
      put<4>(&out[kTextureAt + 4 * i],
             std::bit_cast<std::uint32_t>(corners.texture[triangle][k][i]));
    }
    for (std::size_t i = 0; i < 4 && !corners.colors.empty(); ++i) {
      const double of_255 = std::round(255 * within(corners.colors[triangle][k][i], 0, 1));
      put<1>(&out[kColorAt + i], static_cast<std::uint32_t>(of_255));
    }
    return out;
  }

  bool textured() const { return textured_; }

  Vector3 low;
  Vector3 step;

 private:
  const mesh::TriangleMesh& mesh_;
  bool textured_;
};

std::string column(const std::vector<PackedVertex>& vertices, std::size_t at, std::size_t bytes) {
  std::string out;
  out.reserve(vertices.size() * bytes);
  for (const PackedVertex& vertex : vertices) out.append(&vertex[at], bytes);
  return out;
}

std::string packed_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
  const std::size_t bytes = vertices > kMaxShortIndices ? 4 : 2;
  std::string out(indices.size() * bytes, '\0');
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (bytes == 4) {
      put<4>(&out[4 * i], indices[i]);
    } else {
      put<2>(&out[2 * i], indices[i]);
    }
  }
  return out;
}

}  // namespace

PageMesh PageBytes::add(const mesh::TriangleMesh& mesh, Textured textured) {
  const CornerPacker packer(mesh, textured);
  VertexTable table(3 * mesh.triangles.size());
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) indices.push_back(table.index_of(packer.corner(t, k)));
  }
  const std::vector<PackedVertex>& vertices = table.vertices();
  PageMesh out{.vertices = vertices.size(),
               .triangles = mesh.triangles.size(),
               .low = packer.low,
               .step = packer.step};
  out.positions = append(column(vertices, 0, 6));
  if (!mesh.corners.normals.empty()) out.normals = append(column(vertices, kNormalAt, 3));
  if (packer.textured()) out.uvs = append(column(vertices, kTextureAt, 8));
  if (!mesh.corners.colors.empty()) out.colors = append(column(vertices, kColorAt, 4));
  out.indices = append(packed_indices(indices, vertices.size()));
  return out;
}

std::string PageBytes::text() const {
  if (bytes_.empty()) return {};
  uLongf size = compressBound(bytes_.size());
  std::string packed(size, '\0');
  const auto* from = reinterpret_cast<const Bytef*>(bytes_.data());
  auto* to = reinterpret_cast<Bytef*>(packed.data());
  // There is room, and the level exists: what is left is memory.
  if (compress2(to, &size, from, bytes_.size(), kPageCompression) != Z_OK) throw std::bad_alloc();
  packed.resize(size);
  return base64(packed);
}

ByteRange PageBytes::append(const std::string& numbers) {
  const ByteRange range{bytes_.size(), numbers.size()};
  bytes_ += numbers;
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  return range;
}

}  // namespace rigor::report
