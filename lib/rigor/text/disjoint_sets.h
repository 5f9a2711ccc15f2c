// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which of many numbered things are connected, learned pair by pair. The least of a set represents it.
// (Union-find with path halving: R. Tarjan, J. van Leeuwen, 1984.)
//
//   DisjointSets sets(triangles.size());
//   sets.join(a, b);
//   if (sets.find(c) == sets.find(a)) together();

#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace rigor {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  /// What represents the set that `i` is in.
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  std::uint32_t find(std::uint32_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }

  /// Returns whether they were apart.
  bool join(std::uint32_t a, std::uint32_t b) {
    if (parent_[a] == parent_[b]) return false;
    a = find(a);
    b = find(b);
    if (a < b) {
      parent_[b] = a;
    } else {
      parent_[a] = b;
    }
    return a != b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace rigor
