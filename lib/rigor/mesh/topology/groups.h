// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which of many numbered things hang together, learnt pair by pair. The least of a group stands for it.
// (Union-find with path halving: R. Tarjan, J. van Leeuwen, 1984.)
//
//   Groups groups(triangles.size());
//   groups.join(a, b);
//   if (groups.find(c) == groups.find(a)) together();

#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace rigor::mesh {

class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
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

}  // namespace rigor::mesh
