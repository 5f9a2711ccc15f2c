// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/edge_balance.h>

#include <bit>

namespace rigor::mesh {
namespace {

// Odd constants without pattern: the fractional bits of the square roots of 2, 3, 5 and 7, and of the
// golden ratio.
constexpr std::uint64_t kRoot2 = 0x6a09e667f3bcc909U;
constexpr std::uint64_t kRoot3 = 0xbb67ae8584caa73bU;
constexpr std::uint64_t kRoot5 = 0x3c6ef372fe94f82bU;
constexpr std::uint64_t kRoot7 = 0xa54ff53a5f1d36f1U;
constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;

/// The halves of the 128-bit product, folded: every bit of the result depends on every bit of both.
std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = static_cast<Wide>(a) * b;
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64U);
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value + 0.0); }  // -0 is 0

std::uint64_t hash(const Vector3& p) {
  return mix(mix(bits(p.x) ^ kRoot2, bits(p.y) ^ kRoot3) ^ bits(p.z), kGolden);
}

/// Antisymmetric: the edge from b to a adds what the edge from a to b takes.
std::uint64_t directed(std::uint64_t a, std::uint64_t b) {
  if (a == b) return 0;
  return a < b ? mix(a ^ kRoot5, b ^ kRoot7) : -mix(b ^ kRoot5, a ^ kRoot7);
}

}  // namespace

void EdgeBalance::add(const Facet& facet) {
  const std::uint64_t a = hash(facet[0]);
  const std::uint64_t b = hash(facet[1]);
  const std::uint64_t c = hash(facet[2]);
  sum_ += directed(a, b) + directed(b, c) + directed(c, a);
}

}  // namespace rigor::mesh
