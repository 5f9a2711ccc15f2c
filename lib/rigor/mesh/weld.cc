// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/weld.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include <rigor/mesh/position_hash.h>

namespace rigor::mesh {
namespace {

constexpr std::uint32_t kNoPosition = std::numeric_limits<std::uint32_t>::max();

// Six triangles meet at a vertex of most meshes, so an STL names each place six times.
constexpr std::size_t kExpectedUses = 6;

bool same_place(const Vector3& a, const Vector3& b) {
  return coordinate_bits(a.x) == coordinate_bits(b.x) &&
         coordinate_bits(a.y) == coordinate_bits(b.y) &&
         coordinate_bits(a.z) == coordinate_bits(b.z);
}

/// Open addressing, linear probing, at most half full. A slot keeps the hash, so that positions are
/// compared hardly ever in vain and the table grows without looking at them. Memory is waited for once
/// a block, not once a position.
class PlaceTable {
 public:
  explicit PlaceTable(const std::vector<Vector3>& positions)
      : positions_(positions), slots_(std::bit_ceil(2 * positions.size() / kExpectedUses + 16)) {
    welded_.place.resize(positions.size());
    welded_.first.reserve(positions.size() / kExpectedUses);
  }

  Weld run() {
    for (std::size_t begin = 0; begin < positions_.size(); begin += kBlock) {
      const std::size_t count = std::min(kBlock, positions_.size() - begin);
      std::array<std::uint32_t, kBlock> hashes;
      for (std::size_t i = 0; i < count; ++i) {
        hashes[i] = static_cast<std::uint32_t>(position_hash(positions_[begin + i]) >> 32U);
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
    std::uint32_t position = kNoPosition;  ///< the first in its place
  };

  std::size_t home(std::uint32_t hash) const { return hash & (slots_.size() - 1); }
  std::size_t after(std::size_t slot) const { return (slot + 1) & (slots_.size() - 1); }

  void fetch(const Slot& slot) const {
    if (slot.position == kNoPosition) return;
    __builtin_prefetch(&positions_[slot.position]);
    __builtin_prefetch(&welded_.place[slot.position]);
  }

  void place(std::size_t position, std::uint32_t hash) {
    const Vector3& p = positions_[position];
    std::size_t at = home(hash);
    for (; slots_[at].position != kNoPosition; at = after(at)) {
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
      if (slot.position == kNoPosition) continue;
      std::size_t at = home(slot.hash);
      while (slots_[at].position != kNoPosition) at = after(at);
      slots_[at] = slot;
    }
  }

  const std::vector<Vector3>& positions_;
  std::vector<Slot> slots_;
  Weld welded_;
};

}  // namespace

Weld weld(const std::vector<Vector3>& positions) { return PlaceTable(positions).run(); }

}  // namespace rigor::mesh
