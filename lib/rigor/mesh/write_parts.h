// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the writers of meshes share: numbers as text and as bytes, names, welded parts.

#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// The fewest digits that read back as the same double. Without an exponent from a micrometre to
/// 10¹⁵ m: assimp takes decimals up to the 15th as they are, but an exponent in single precision.
void append_number(std::string& text, double value);
void append_number(std::string& text, const Vector3& p);  ///< x, y and z with spaces between

/// In little-endian bytes.
template <class Number>
void append_bytes(std::string& bytes, Number value) {
  using Bits = std::conditional_t<sizeof value == 8, std::uint64_t, std::uint32_t>;
  const auto bits = std::bit_cast<Bits>(value);
  for (std::size_t i = 0; i < sizeof value; ++i) {
    bytes += static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
  }
}

/// The nearest 32-bit number; -0 becomes 0. A function of one number on purpose: of three
/// conversions there and back side by side gcc 12.2 -O2 leaves some out.
inline double as_float(double value) { return static_cast<float>(value) + 0.0; }

/// In one line of UTF-8: tabs and line ends become spaces, what XML and UTF-8 do not allow becomes
/// U+FFFD.
std::string clean(std::string name);

/// Perpendicular to a triangle, of length 1, in 32-bit numbers, as it only lights a picture; zero
/// when the triangle has no area.
Vector3 unit_normal(const Facet& f);

/// The parts that have triangles; the whole mesh as one without a name when it has no parts.
std::vector<Part> parts_with_triangles(const TriangleMesh& mesh);

/// The different names of materials, in order of appearance, and the one of each part.
struct Materials {
  std::vector<std::string> names;
  std::vector<std::size_t> of_part;
};

Materials materials_of(const std::vector<Part>& parts);

/// Some triangles with only the positions that they use, each once, in order of appearance.
struct Welded {
  std::vector<Vector3> positions;
  std::vector<Triangle> triangles;
};

enum class Precision : std::uint8_t {
  kFloat,  ///< coordinates are rounded first, so that what becomes equal is one
  kDouble
};

/// `part` with a range of triangles.
Welded welded(const TriangleMesh& mesh, const Part& part, Precision precision);
Welded welded(const TriangleMesh& mesh);

}  // namespace rigor::mesh
