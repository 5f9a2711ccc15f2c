// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/weld.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <rigor/mesh/topology/position_hash.h>

namespace rigor::mesh {
namespace {

// Six triangles meet at a vertex of most meshes, so an STL names each place six times.
constexpr std::size_t kExpectedUses = 6;

// Fewer places stay near the processor without being sent for.
constexpr std::size_t kNearPlaces = 20'000;

bool same_place(const Vector3& a, const Vector3& b) {
  // One jump: which coordinate differs is of no interest.
  return ((coordinate_bits(a.x) ^ coordinate_bits(b.x)) |
          (coordinate_bits(a.y) ^ coordinate_bits(b.y)) |
          (coordinate_bits(a.z) ^ coordinate_bits(b.z))) == 0;
}

/// Open addressing, linear probing, at most half full, a quarter as a rule. Places are kept together,
/// so that those of most meshes fit into the caches. Memory is waited for once a block, not once a
/// position.
class PlaceTable {
 public:
  explicit PlaceTable(const std::vector<Vector3>& positions)
      : positions_(positions), slots_(std::bit_ceil(4 * positions.size() / kExpectedUses + 16)) {
    welded_.place.resize(positions.size());
    welded_.first.reserve(positions.size() / kExpectedUses);
    places_.reserve(positions.size() / kExpectedUses);
  }

  Weld run() {
    std::array<std::size_t, kBlock> hashes;
    for (std::size_t begin = 0; begin < positions_.size(); begin += kBlock) {
      const std::size_t count = std::min(kBlock, positions_.size() - begin);
      for (std::size_t i = 0; i < count; ++i) {
        hashes[i] = hash(positions_[begin + i]);
        __builtin_prefetch(&slots_[home(hashes[i])]);
      }
      for (std::size_t i = 0; i < count && places_.size() > kNearPlaces; ++i) {
        const std::uint32_t slot = slots_[home(hashes[i])];
        if (slot != kEmpty) __builtin_prefetch(&places_[slot - 1]);
      }
      for (std::size_t i = 0; i < count; ++i) {
        welded_.place[begin + i] = place(begin + i, hashes[i]);
      }
    }
    return std::move(welded_);
  }

 private:
  static constexpr std::size_t kBlock = 256;
  static constexpr std::uint32_t kEmpty = 0;  // other slots hold a place's number plus one

  static std::size_t hash(const Vector3& position) { return position_hash(position) >> 32U; }
  std::size_t home(std::size_t hash) const { return hash & (slots_.size() - 1); }
  std::size_t after(std::size_t slot) const { return (slot + 1) & (slots_.size() - 1); }

  std::uint32_t place(std::size_t position, std::size_t hash) {
    const Vector3& p = positions_[position];
    std::size_t at = home(hash);
    for (; slots_[at] != kEmpty; at = after(at)) {
      if (same_place(places_[slots_[at] - 1], p)) return slots_[at] - 1;
    }
    places_.push_back(p);
    welded_.first.push_back(static_cast<std::uint32_t>(position));
    slots_[at] = static_cast<std::uint32_t>(places_.size());
    if (2 * places_.size() > slots_.size()) grow();
    return static_cast<std::uint32_t>(places_.size() - 1);
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kEmpty);
    for (std::uint32_t place = 0; place < places_.size(); ++place) {
      std::size_t at = home(hash(places_[place]));
      while (slots_[at] != kEmpty) at = after(at);
      slots_[at] = place + 1;
    }
  }

  const std::vector<Vector3>& positions_;
  std::vector<std::uint32_t> slots_;
  std::vector<Vector3> places_;
  Weld welded_;
};

}  // namespace

Weld weld(const std::vector<Vector3>& positions) { return PlaceTable(positions).run(); }

}  // namespace rigor::mesh
