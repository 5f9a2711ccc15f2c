// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/edge_balance.h>

#include <rigor/mesh/topology/position_hash.h>
#include <rigor/mesh/topology/thinness.h>

namespace rigor::mesh {
namespace {

// Odd constants without pattern: the fractional bits of the square roots of 5 and 7.
constexpr std::uint64_t kRoot5 = 0x3c6ef372fe94f82bU;
constexpr std::uint64_t kRoot7 = 0xa54ff53a5f1d36f1U;

/// Antisymmetric: the edge from b to a adds what the edge from a to b takes.
std::uint64_t directed(std::uint64_t a, std::uint64_t b) {
  if (a == b) return 0;
  return a < b ? mix(a ^ kRoot5, b ^ kRoot7) : -mix(b ^ kRoot5, a ^ kRoot7);
}

}  // namespace

void EdgeBalance::add(const Facet& facet) {
  const std::uint64_t a = position_hash(facet[0]);
  const std::uint64_t b = position_hash(facet[1]);
  const std::uint64_t c = position_hash(facet[2]);
  sum_ += directed(a, b) + directed(b, c) + directed(c, a);
  if (!has_area_) {
    has_area_ = a != b && b != c && c != a && thinness(facet) != Thinness::kLine;
  }
}

}  // namespace rigor::mesh
