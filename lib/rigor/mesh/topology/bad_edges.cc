// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/bad_edges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include <rigor/mesh/topology/position_hash.h>

namespace rigor::mesh {
namespace {

// Of more, sorting finds the pairs faster than comparing all.
constexpr std::size_t kMaxCompared = 16;

/// A triangle's side, seen from its lower place.
struct Side {
  std::uint32_t high;
  std::uint32_t
      code;  ///< twice the triangle, and one when it runs from the lower place to the higher

  std::uint32_t face() const { return code / 2; }
  bool upward() const { return code % 2 != 0; }
};

/// Whether each side has one other at its edge, which runs the other way.
bool all_paired(std::span<const Side> sides) {
  if (sides.size() % 2 != 0 || sides.size() > kMaxCompared) return false;
  bool paired = true;
  for (const Side& side : sides) {
    unsigned count = 0;
    unsigned upward = 0;
    for (const Side& other : sides) {
      const unsigned same = other.high == side.high ? 1 : 0;
      count += same;
      upward += same & other.code;
    }
    paired &= count == 2 && upward == 1;
  }
  return paired;
}

/// Adds those of one lower place.
void add_bad(std::uint32_t low, std::span<Side> sides, std::vector<BadEdge>& edges) {
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.high, a.code) < std::pair(b.high, b.code);
  });
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].high == sides[begin].high) ++end;
    const std::size_t count = end - begin;
    if (count == 2 && sides[begin].upward() != sides[begin + 1].upward()) continue;
    const Defect defect = count == 1   ? Defect::kBoundaryEdge
                          : count == 2 ? Defect::kInconsistentEdge
                                       : Defect::kNonmanifoldEdge;
    edges.push_back({low, sides[begin].high, sides[begin].face(), defect});
  }
}

template <class Use>
void for_each_side(const Triangle& p, std::uint32_t face, const Use& use) {
  for (const auto& [from, to] : {std::pair(p[0], p[1]), {p[1], p[2]}, {p[2], p[0]}}) {
    // Which is lower is as good as random: no branch may hang on it.
    use(std::min(from, to), Side{std::max(from, to), 2 * face + (from < to ? 1U : 0U)});
  }
}

template <class Use>
void for_each_side(const TriangleMesh& mesh, const Weld& welded, const Use& use) {
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    const Triangle p = places_of(welded, mesh.triangles[face]);
    if (!degenerate(p)) for_each_side(p, face, use);
  }
}

std::uint64_t number_hash(std::uint32_t number) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;  // the golden ratio's fractional bits
  return mix(number + kGolden, kGolden);
}

constexpr std::uint8_t kOpen = 1;
constexpr std::uint8_t kAsked = 2;

/// Marks the places round which sides do not cancel: each adds a hash of the place that it leads to,
/// with the sign of its direction, so that what runs there and back leaves zero. (An open edge leaves
/// it once in 2^64 cases.)
void mark_open(const TriangleMesh& mesh, const Weld& welded, std::vector<std::uint8_t>& marks) {
  std::vector<std::uint64_t> sums(welded.places());
  for (const Triangle& t : mesh.triangles) {
    const Triangle p = places_of(welded, t);
    if (degenerate(p)) continue;
    const std::array<std::uint64_t, 3> hash = {number_hash(p[0]), number_hash(p[1]),
                                               number_hash(p[2])};
    sums[p[0]] += hash[1] - hash[2];
    sums[p[1]] += hash[2] - hash[0];
    sums[p[2]] += hash[0] - hash[1];
  }
  for (std::size_t place = 0; place < sums.size(); ++place) {
    if (sums[place] != 0) marks[place] |= kOpen;
  }
}

/// A side and the lower place that it is seen from.
struct SideAt {
  std::uint32_t low;
  Side side;
};

std::vector<SideAt> sides_at(const TriangleMesh& mesh, const Weld& welded,
                             const std::vector<std::uint8_t>& marks) {
  std::vector<SideAt> found;
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    const Triangle p = places_of(welded, mesh.triangles[face]);
    if ((marks[p[0]] | marks[p[1]] | marks[p[2]]) == 0 || degenerate(p)) continue;
    for_each_side(p, face, [&](std::uint32_t low, const Side& side) {
      const unsigned either = marks[low] | marks[side.high];
      const unsigned both = marks[low] & marks[side.high];
      if ((either & kAsked) != 0 || (both & kOpen) != 0) found.push_back({low, side});
    });
  }
  return found;
}

/// Of the sides that `each` tells of: each(use) calls use(low, side).
template <class Each>
std::vector<BadEdge> bad_among(std::size_t places, const Each& each) {
  // Filling moves each place's begin to its end, which is the next one's begin.
  std::vector<std::uint32_t> end(places + 1);
  each([&](std::uint32_t low, const Side&) { ++end[low + 1]; });
  for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
  const auto sides = std::make_unique_for_overwrite<Side[]>(end.back());
  each([&](std::uint32_t low, const Side& side) { sides[end[low]++] = side; });

  std::vector<BadEdge> edges;
  std::uint32_t begin = 0;
  for (std::uint32_t low = 0; low < places; ++low) {
    const std::span here(sides.get() + begin, end[low] - begin);
    begin = end[low];
    if (!all_paired(here)) add_bad(low, here, edges);
  }
  return edges;
}

}  // namespace

std::vector<BadEdge> bad_edges_at(const TriangleMesh& mesh, const Weld& welded,
                                  const std::vector<std::uint32_t>& places, bool and_open) {
  std::vector<std::uint8_t> marks(welded.places());
  if (and_open) mark_open(mesh, welded, marks);
  for (const std::uint32_t place : places) marks[place] |= kAsked;
  const std::vector<SideAt> found = sides_at(mesh, welded, marks);
  return bad_among(welded.places(), [&](const auto& use) {
    for (const auto& [low, side] : found) use(low, side);
  });
}

std::vector<BadEdge> bad_edges_of(const TriangleMesh& mesh, const Weld& welded) {
  return bad_among(welded.places(), [&](const auto& use) { for_each_side(mesh, welded, use); });
}

}  // namespace rigor::mesh
