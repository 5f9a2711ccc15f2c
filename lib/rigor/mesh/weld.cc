// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/weld.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace rigor::mesh {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Six triangles meet at a vertex of most meshes, so an STL names each place six times.
constexpr std::size_t kExpectedUses = 6;

// Odd constants without pattern: the fractional bits of the square roots of 2 and 3, and of the
// golden ratio.
constexpr std::uint64_t kRoot2 = 0x6a09e667f3bcc909U;
constexpr std::uint64_t kRoot3 = 0xbb67ae8584caa73bU;
constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;

/// Bits, so that a NaN equals itself and the table holds it once.
std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value + 0.0); }  // -0 is 0

bool same_place(const Vector3& a, const Vector3& b) {
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

/// The halves of the 128-bit product, folded.
std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = static_cast<Wide>(a) * b;
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64U);
}

std::uint32_t hash(const Vector3& p) {
  const std::uint64_t xy = mix(bits(p.x) ^ kRoot2, bits(p.y) ^ kRoot3);
  return static_cast<std::uint32_t>(mix(xy ^ bits(p.z), kGolden) >> 32U);
}

/// Open addressing, linear probing, at most half full. A slot keeps the hash, so that positions are
/// compared hardly ever in vain and the table grows without looking at them. Memory is waited for once
/// a block, not once a position.
class Places {
 public:
  explicit Places(const std::vector<Vector3>& positions)
      : positions_(positions), slots_(std::bit_ceil(2 * positions.size() / kExpectedUses + 16)) {
    welded_.place.resize(positions.size());
    welded_.first.reserve(positions.size() / kExpectedUses);
  }

  Weld run() {
    for (std::size_t begin = 0; begin < positions_.size(); begin += kBlock) {
      const std::size_t count = std::min(kBlock, positions_.size() - begin);
      std::array<std::uint32_t, kBlock> hashes;
      for (std::size_t i = 0; i < count; ++i) {
        hashes[i] = hash(positions_[begin + i]);
        __builtin_prefetch(&slots_[home(hashes[i])]);
      }
      for (std::size_t i = 0; i < count; ++i) fetch(slots_[home(hashes[i])]);
      for (std::size_t i = 0; i < count; ++i) place(begin + i, hashes[i]);
    }
    return std::move(welded_);
  }

 private:
  static constexpr std::size_t kBlock = 256;

  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t position = kNone;  ///< the first in its place
  };

  std::size_t home(std::uint32_t hash) const { return hash & (slots_.size() - 1); }
  std::size_t after(std::size_t slot) const { return (slot + 1) & (slots_.size() - 1); }

  void fetch(const Slot& slot) const {
    if (slot.position == kNone) return;
    __builtin_prefetch(&positions_[slot.position]);
    __builtin_prefetch(&welded_.place[slot.position]);
  }

  void place(std::size_t position, std::uint32_t hash) {
    const Vector3& p = positions_[position];
    std::size_t at = home(hash);
    for (; slots_[at].position != kNone; at = after(at)) {
      const Slot& slot = slots_[at];
      if (slot.hash != hash || !same_place(positions_[slot.position], p)) continue;
      welded_.place[position] = welded_.place[slot.position];
      return;
    }
    slots_[at] = {hash, static_cast<std::uint32_t>(position)};
    welded_.place[position] = static_cast<std::uint32_t>(welded_.first.size());
    welded_.first.push_back(static_cast<std::uint32_t>(position));
    if (2 * welded_.first.size() > slots_.size()) grow();
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.position == kNone) continue;
      std::size_t at = home(slot.hash);
      while (slots_[at].position != kNone) at = after(at);
      slots_[at] = slot;
    }
  }

  const std::vector<Vector3>& positions_;
  std::vector<Slot> slots_;
  Weld welded_;
};

}  // namespace

Weld weld(const std::vector<Vector3>& positions) { return Places(positions).run(); }

}  // namespace rigor::mesh
