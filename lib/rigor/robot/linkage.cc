// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/linkage.h>

#include <algorithm>

namespace rigor::robot {

Linkage::Linkage(const model::Root& root, const model::Frames& frames)
    : bodies_(root.links.size()) {
  std::vector<Ends> hinges;
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const auto& ends = frames.ends({i});
    if (!ends.parent || !ends.child) continue;
    if (root.joints[i].type == model::JointType::kFixed) {
      bodies_.join(ends.parent.value, ends.child.value);
    } else {
      hinges.emplace_back(ends.parent.value, ends.child.value);
    }
  }
  skip_links_without_shape(root, hinges);
  for (const auto& [parent, child] : hinges) {
    neighbors_.insert(std::minmax(bodies_.find(parent), bodies_.find(child)));
  }
}

bool Linkage::are_neighbors(model::Id<model::Link> a, model::Id<model::Link> b) {
  const Ends pair = std::minmax(bodies_.find(a.value), bodies_.find(b.value));
  return pair.first == pair.second || neighbors_.contains(pair);
}

void Linkage::skip_links_without_shape(const model::Root& root, const std::vector<Ends>& hinges) {
  std::vector<bool> touchable(root.links.size(), false);
  for (std::uint32_t i = 0; i < touchable.size(); ++i) {
    if (!root.links[i].collisions.empty()) touchable[bodies_.find(i)] = true;
  }
  for (const auto& [parent, child] : hinges) {
    const std::uint32_t before = bodies_.find(parent), after = bodies_.find(child);
    if (touchable[after] || after == before) continue;
    bodies_.join(parent, child);
    // What represents both is as touchable as the parent.
    touchable[bodies_.find(parent)] = touchable[before];
  }
}

}  // namespace rigor::robot
