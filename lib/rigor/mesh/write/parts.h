// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the writers of meshes share: numbers as text and as bytes, names, welded parts with what
// their corners carry.

#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// The fewest digits that read back as the same double. Without an exponent from a micrometer to
/// 10¹⁵ m: assimp takes decimals up to the 15th as they are, but an exponent in single precision.
void append_number(std::string& text, double value);
void append_number(std::string& text, const Vector3& p);  ///< x, y and z with spaces between

/// Each of a corner's numbers with a blank before it.
template <std::size_t kSize>
void append_numbers(std::string& text, const std::array<float, kSize>& values) {
  for (const float value : values) {
    text += ' ';
    append_number(text, double{value});
  }
}

/// In little-endian bytes.
template <class Number>
void append_bytes(std::string& bytes, Number value) {
  using Bits = std::conditional_t<sizeof value == 8, std::uint64_t, std::uint32_t>;
  const auto bits = std::bit_cast<Bits>(value);
  for (std::size_t i = 0; i < sizeof value; ++i) {
    bytes += static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
  }
}

template <std::size_t kSize>
void append_bytes(std::string& bytes, const std::array<float, kSize>& values) {
  for (const float value : values) append_bytes(bytes, value);
}

/// The nearest 32-bit number; -0 becomes 0.
double as_float(double value);

/// In one line of UTF-8: tabs and line ends become spaces, what XML and UTF-8 do not allow becomes
/// U+FFFD.
std::string clean(std::string name);

/// A path as a relative reference: what has a meaning in one, and what is not ASCII, becomes %xx
/// (RFC 3986, 2).
std::string uri(const std::string& path);

/// The parts that have triangles; the whole mesh as one without a name when it has no parts.
std::vector<Part> parts_with_triangles(const TriangleMesh& mesh);

/// A material that parts name, and how it looks when the mesh knows.
struct Look {
  std::string name;
  const Material* material;
};

/// The different ones, in order of appearance, and the one of each part.
struct Looks {
  std::vector<Look> looks;
  std::vector<std::size_t> of_part;
};

Looks looks_of(const TriangleMesh& mesh, const std::vector<Part>& parts);

/// The whole mesh as one part.
Part whole(const TriangleMesh& mesh);

/// What the corners of a mesh's parts carry, without -0. Texture points that are all zero and
/// colors that are all white count as not carried when others of the mesh are not so. Where a part
/// carries normals, corners without one get their triangle's.
class PartCorners {
 public:
  explicit PartCorners(const TriangleMesh& mesh);

  Corners of(const Part& part) const;  ///< with entries for its triangles only

 private:
  const TriangleMesh& mesh_;
  bool any_texture_;
  bool any_color_;
};

/// For each corner of a part its triangle's normal.
std::vector<std::array<Corners::Normal, 3>> flat_normals(const TriangleMesh& mesh,
                                                         const Part& part);

/// Values of corners, each once in order of appearance, and which ones each triangle's corners
/// have.
template <class Value>
struct Indexed {
  std::vector<Value> values;
  std::vector<Triangle> triangles;
};

Indexed<Corners::Texture> indexed(const std::vector<std::array<Corners::Texture, 3>>& corners);
Indexed<Corners::Normal> indexed(const std::vector<std::array<Corners::Normal, 3>>& corners);
Indexed<Corners::Color> indexed(const std::vector<std::array<Corners::Color, 3>>& corners);

enum class Precision : std::uint8_t {
  kFloat,  ///< coordinates are rounded first, so that what becomes equal is one
  kDouble
};

/// The same of the places of a part's corners.
Indexed<Vector3> indexed_positions(const TriangleMesh& mesh, const Part& part, Precision precision);

/// Some triangles with only the vertices that they use, each once, in order of appearance. Those of
/// one place that carry different things are different ones.
struct Welded {
  std::vector<Vector3> positions;
  std::vector<Triangle> triangles;
  // One for each position, or none:
  std::vector<Corners::Texture> texture;
  std::vector<Corners::Normal> normals;
  std::vector<Corners::Color> colors;
};

/// The part's triangles with what their corners carry: `corners` has entries for just these.
Welded welded(const TriangleMesh& mesh, const Part& part, const Corners& corners,
              Precision precision);

}  // namespace rigor::mesh
