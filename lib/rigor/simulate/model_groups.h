// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Models that joints hold together, and which of them are held by the world. For sources of this room.
//
//   const ModelGroups groups(scene);
//   if (groups.held(groups.root(model))) stays_there();

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/simulate/scene/scene.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::simulate {

class ModelGroups {
 public:
  /// The scene outlives it.
  explicit ModelGroups(const Scene& scene);

  /// One model of those that are held together: the same for all of them.
  std::uint32_t root(std::uint32_t model) const { return groups_.find(model); }

  /// Whether one of the group is static, or a joint holds it to the world.
  bool held(std::uint32_t root) const { return held_[root] != 0; }

 private:
  std::uint32_t model_of(std::uint32_t body) const;
  void join(std::uint32_t a, std::uint32_t b);

  const Scene& scene_;
  DisjointSets groups_;
  std::vector<unsigned char> held_;
};

}  // namespace rigor::simulate
