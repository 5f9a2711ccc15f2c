// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Hashes of positions by their exact coordinates, where -0 is 0 and a NaN is itself.

#pragma once

#include <bit>
#include <cstdint>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

inline std::uint64_t coordinate_bits(double value) {
  return std::bit_cast<std::uint64_t>(value + 0.0);  // -0 is 0
}

/// The halves of the 128-bit product, folded: every bit of the result depends on every bit of both.
inline std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = static_cast<Wide>(a) * b;
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64U);
}

inline std::uint64_t position_hash(const Vector3& p) {
  // Odd constants without pattern: the fractional bits of the square roots of 2 and 3, and of the
  // golden ratio.
  constexpr std::uint64_t kRoot2 = 0x6a09e667f3bcc909U;
  constexpr std::uint64_t kRoot3 = 0xbb67ae8584caa73bU;
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;
  const std::uint64_t xy = mix(coordinate_bits(p.x) ^ kRoot2, coordinate_bits(p.y) ^ kRoot3);
  return mix(xy ^ coordinate_bits(p.z), kGolden);
}

}  // namespace rigor::mesh
