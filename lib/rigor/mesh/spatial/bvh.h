// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A tree of axis-aligned boxes over triangles, to find which are near each other or near a place.
//
// Triangles are halved along the longest side of what their middles take up, again and again, until
// eight or fewer are left; each eight neighbors in that order are a block, each eight blocks one of
// the level above. So the tree is one list of blocks without pointers, its depth is the logarithm of
// the number of triangles, whatever they are, and the same triangles always make the same tree.
// (Packed trees: I. Kamel, C. Faloutsos, "On packing R-trees", 1993.)
//
//   const Bvh tree(mesh);
//   const Nearest near = tree.nearest(p);
//   tree.pairs(budget, [&](std::uint32_t i, std::uint32_t j) { return ask(tree.facet(i), …); });

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Coordinates are no larger than this, in size: no unit makes a robot so large, and in floats, as the
/// boxes are, sums and differences of them are still finite.
inline constexpr double kFarthest = 0x1p100;

inline bool within_reach(const Vector3& p) {
  return std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest && std::abs(p.z) <= kFarthest;
}

/// The place of a triangle next to p. One without an area is its longest edge.
Vector3 closest_point(const Facet& f, const Vector3& p);

struct Nearest {
  std::uint32_t slot = 0;
  Vector3 at;
  double distance = 0;
  std::uint64_t looks = 0;  ///< boxes and triangles that were examined
};

class Bvh {
 public:
  /// Over the triangles of a mesh that are within reach.
  explicit Bvh(const TriangleMesh& mesh);
  /// Over these triangles, which are within reach.
  explicit Bvh(const std::vector<Facet>& facets);

  /// Triangles are named by their slots in the tree's order, from 0.
  std::size_t size() const { return facets_.size(); }
  const Facet& facet(std::uint32_t slot) const { return facets_[slot]; }
  /// The index that the triangle of a slot has in the mesh or list that the tree was made of.
  std::uint32_t index(std::uint32_t slot) const { return indices_[slot]; }

  /// Calls `visit(slot)` for each triangle whose box touches `box`, until it returns false.
  template <class Visit>
  void touching(const Bounds& box, const Visit& visit) const;

  /// Calls `visit(i, j)`, with i < j, once for every two triangles whose boxes touch. Gives up, and
  /// returns false, when that takes more looks at boxes and pairs than `budget` or `visit` returns
  /// false.
  template <class Visit>
  bool pairs(std::uint64_t budget, const Visit& visit) const;

  /// The place of the triangles next to p; any that is not farther than `enough` will do. `guess` is
  /// examined first: a good one saves time. There must be a triangle.
  Nearest nearest(const Vector3& p, std::uint32_t guess = 0, double enough = 0) const;

 private:
  static constexpr std::uint32_t kWidth = 8;
  static constexpr std::uint32_t kWidthBits = 3;
  static constexpr std::size_t kMaxLevels = 11;  // 8^11 is beyond 32 bits
  static constexpr float kFar = std::numeric_limits<float>::infinity();

  /// Rounded to the outside.
  struct Box {
    std::array<float, 3> min{kFar, kFar, kFar};
    std::array<float, 3> max{-kFar, -kFar, -kFar};
  };

  /// The boxes of eight neighbors, side by side, so that they are compared at once.
  struct Block {
    Block();
    void set(std::uint32_t child, const Box& box);
    Box at(std::uint32_t child) const;
    Box all() const;
    std::uint32_t touched_by(const Box& box) const;  ///< a bit for each child
    std::array<double, kWidth> squared_distances(const Vector3& p) const;

    std::array<std::array<float, kWidth>, 3> min;
    std::array<std::array<float, kWidth>, 3> max;
  };

  struct Node {
    std::uint32_t level;  // 0 for blocks of triangles
    std::uint32_t block;  // in its level
  };

  /// Nodes still to be examined: of each level, no more than all children of one block.
  template <class Entry>
  class Stack {
   public:
    bool empty() const { return size_ == 0; }
    void push(const Entry& entry) { entries_[size_++] = entry; }
    Entry pop() { return entries_[--size_]; }

   private:
    std::array<Entry, kMaxLevels * kWidth> entries_;
    std::size_t size_ = 0;
  };

  static Box box_around(const Bounds& bounds);
  void build(const std::vector<Facet>& facets);
  void stack_levels();

  const Block& block(Node node) const { return blocks_[level_begin_[node.level] + node.block]; }
  Node root() const { return {static_cast<std::uint32_t>(level_begin_.size() - 1), 0}; }
  std::uint32_t leaves() const {
    return static_cast<std::uint32_t>((size() + kWidth - 1) / kWidth);
  }

  /// Calls `visit(leaf)` for each block of triangles from `first` on whose box touches `box`; returns
  /// the number of blocks that were examined, or stops when `visit` returns false.
  template <class Visit>
  std::uint64_t leaves_touching(const Box& box, std::uint32_t first, const Visit& visit) const;

  std::vector<Facet> facets_;
  std::vector<std::uint32_t> indices_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> level_begin_;  // of each level, in the blocks
};

inline std::uint32_t Bvh::Block::touched_by(const Box& box) const {
  std::array<std::uint32_t, kWidth> hit;
  for (std::size_t i = 0; i < kWidth; ++i) {
    hit[i] = static_cast<std::uint32_t>(min[0][i] <= box.max[0]) &
             static_cast<std::uint32_t>(max[0][i] >= box.min[0]) &
             static_cast<std::uint32_t>(min[1][i] <= box.max[1]) &
             static_cast<std::uint32_t>(max[1][i] >= box.min[1]) &
             static_cast<std::uint32_t>(min[2][i] <= box.max[2]) &
             static_cast<std::uint32_t>(max[2][i] >= box.min[2]);
  }
  std::uint32_t bits = 0;
  for (std::uint32_t i = 0; i < kWidth; ++i) bits |= hit[i] << i;
  return bits;
}

template <class Visit>
std::uint64_t Bvh::leaves_touching(const Box& box, std::uint32_t first, const Visit& visit) const {
  std::uint64_t looks = 0;
  Stack<Node> open;
  open.push(root());
  while (!open.empty()) {
    const Node node = open.pop();
    ++looks;
    if (node.level == 0) {
      if (!visit(node.block)) break;
      continue;
    }
    std::uint32_t hits = block(node).touched_by(box);
    while (hits != 0) {
      const auto child = static_cast<std::uint32_t>(std::countr_zero(hits));
      hits &= hits - 1;
      const Node next{node.level - 1, node.block * kWidth + child};
      const std::uint64_t end = (std::uint64_t{next.block} + 1) << (kWidthBits * next.level);
      if (end > first) open.push(next);
    }
  }
  return looks;
}

template <class Visit>
void Bvh::touching(const Bounds& bounds, const Visit& visit) const {
  if (size() == 0) return;
  const Box box = box_around(bounds);
  leaves_touching(box, 0, [&](std::uint32_t leaf) {
    std::uint32_t hits = block({0, leaf}).touched_by(box);
    for (; hits != 0; hits &= hits - 1) {
      if (!visit(leaf * kWidth + static_cast<std::uint32_t>(std::countr_zero(hits)))) return false;
    }
    return true;
  });
}

template <class Visit>
bool Bvh::pairs(std::uint64_t budget, const Visit& visit) const {
  std::uint64_t looks = 0;
  bool going = true;
  for (std::uint32_t a = 0; a < leaves() && going; ++a) {
    const Block& block_a = block({0, a});
    const std::uint32_t count = std::min(kWidth, static_cast<std::uint32_t>(size()) - a * kWidth);
    looks += leaves_touching(block_a.all(), a, [&](std::uint32_t b) {
      const Block& block_b = block({0, b});
      for (std::uint32_t i = 0; i < count; ++i) {
        std::uint32_t hits = block_b.touched_by(block_a.at(i));
        if (a == b) hits &= ~0U << (i + 1);
        for (; hits != 0 && going; hits &= hits - 1) {
          const auto j = static_cast<std::uint32_t>(std::countr_zero(hits));
          going = ++looks <= budget && visit(a * kWidth + i, b * kWidth + j);
        }
      }
      return going = going && looks <= budget;
    });
  }
  return going;
}

}  // namespace rigor::mesh
