// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/bad_edges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

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
void for_each_side(const TriangleMesh& mesh, const Weld& welded, const Use& use) {
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    const Triangle p = places_of(welded, mesh.triangles[face]);
    if (degenerate(p)) continue;
    for (const auto& [from, to] : {std::pair(p[0], p[1]), {p[1], p[2]}, {p[2], p[0]}}) {
      // Which is lower is as good as random: no branch may hang on it.
      use(std::min(from, to), Side{std::max(from, to), 2 * face + (from < to ? 1U : 0U)});
    }
  }
}

}  // namespace

std::vector<BadEdge> bad_edges_of(const TriangleMesh& mesh, const Weld& welded) {
  // Filling moves each place's begin to its end, which is the next one's begin.
  std::vector<std::uint32_t> end(welded.places() + 1);
  for_each_side(mesh, welded, [&](std::uint32_t low, const Side&) { ++end[low + 1]; });
  for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
  const auto sides = std::make_unique_for_overwrite<Side[]>(end.back());
  for_each_side(mesh, welded,
                [&](std::uint32_t low, const Side& side) { sides[end[low]++] = side; });

  std::vector<BadEdge> edges;
  std::uint32_t begin = 0;
  for (std::uint32_t low = 0; low < welded.places(); ++low) {
    const std::span here(sides.get() + begin, end[low] - begin);
    begin = end[low];
    if (!all_paired(here)) add_bad(low, here, edges);
  }
  return edges;
}

}  // namespace rigor::mesh
