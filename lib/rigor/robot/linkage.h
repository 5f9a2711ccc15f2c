// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which links of a model joints connect: bodies of links that are fixed to each other, and neighbors
// with one joint between them.
//
//   Linkage linkage(root, frames);
//   if (!linkage.are_neighbors(a, b)) collide(a, b);

#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::robot {

class Linkage {
 public:
  Linkage(const model::Root& root, const model::Frames& frames);

  /// Whether no joint moves one against the other, or one joint does. A link without a collision
  /// between two joints makes one joint of them, with two axes.
  bool are_neighbors(model::Id<model::Link> a, model::Id<model::Link> b);

 private:
  using Ends = std::pair<std::uint32_t, std::uint32_t>;

  void skip_links_without_shape(const model::Root& root, const std::vector<Ends>& hinges);

  DisjointSets bodies_;
  std::set<Ends> neighbors_;
};

}  // namespace rigor::robot
