// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether the file has the same coordinates in another place: a twin's, a collision's of its visual, a center of
// mass at a joint. Of several slips that would explain a wrong origin, the one that leaves such is the likely one.
//
//   if (is_written_elsewhere(change.value, pose, context.root())) return change;

#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <rigor/rules/assembly/twin_numbers.h>
#include <rigor/rules/assembly/undone_slips.h>

namespace rigor::rules {

enum class Signs : std::uint8_t { kMayDiffer, kSame };

/// Not counting `but` itself; a coordinate of the value at least has to be other than zero.
inline bool is_written_elsewhere(const model::Vector3& value, const model::PoseField& but,
                                 const model::Root& root, Signs signs = Signs::kMayDiffer) {
  const auto same = [&](const model::PoseField& pose) {
    const model::Vector3& t = pose.pose.value.translation;
    if (&pose == &but || !pose.pose.written) return false;
    if (signs == Signs::kSame && dot(t, value) < (1 - 1e-9) * dot(value, value)) return false;
    return same_size(t.x, value.x) && same_size(t.y, value.y) && same_size(t.z, value.z);
  };
  if (value == model::Vector3{}) return false;
  const auto any = [&](const auto& all) {
    return std::any_of(all.begin(), all.end(), [&](const auto& one) { return same(one.pose); });
  };
  const auto is_mass = [&](const model::Link& link) { return same(link.inertial.pose); };
  return any(root.links) || any(root.joints) || any(root.collisions) || any(root.visuals) ||
         std::any_of(root.links.begin(), root.links.end(), is_mass);
}

/// The change that leaves what is written elsewhere; else the first. Of none, the end.
inline std::vector<Undone>::const_iterator likeliest(const std::vector<Undone>& changes,
                                                     const model::PoseField& pose,
                                                     const model::Root& root) {
  const auto found = std::find_if(changes.begin(), changes.end(), [&](const Undone& change) {
    return is_written_elsewhere(change.value, pose, root);
  });
  return found != changes.end() ? found : changes.begin();
}

}  // namespace rigor::rules
