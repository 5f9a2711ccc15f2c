// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/start.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace rigor::simulate {
namespace {

/// Nothing when the joint has no limits, or none that a place fits between.
const model::Axis* axis_with_limits(const model::Joint& joint) {
  const bool limited =
      joint.type == model::JointType::kRevolute || joint.type == model::JointType::kPrismatic;
  if (!limited || joint.axes.empty() || joint.axes[0].mimic) return nullptr;
  const model::Axis& axis = joint.axes[0];
  return axis.limit_written && axis.lower.value <= axis.upper.value ? &axis : nullptr;
}

/// The followers of what was moved, where their leader's place puts them.
void move_followers(const model::Root& root, Start& start) {
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const model::Joint& joint = root.joints[i];
    if (joint.axes.empty() || !joint.axes[0].mimic) continue;
    const model::Mimic& mimic = *joint.axes[0].mimic;
    for (const model::Id<model::Joint> leader : start.moved) {
      if (root[leader].model != joint.model || root[leader].name.value != mimic.joint.value)
        continue;
      const double at = start.positions[scoped_name(root, leader)][0];
      const double follows = mimic.multiplier.value * at + mimic.offset.value;
      start.positions.emplace(scoped_name(root, model::Id<model::Joint>{i}),
                              std::array<double, 2>{follows, 0});
    }
  }
}

}  // namespace

Start start_within_limits(const model::Root& root, model::JointPositions positions) {
  Start start{std::move(positions), {}};
  if (root.format != model::Format::kUrdf) return start;
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const model::Id<model::Joint> id{i};
    const model::Axis* axis = axis_with_limits(root[id]);
    if (axis == nullptr) continue;
    const double nearest = std::clamp(0.0, axis->lower.value, axis->upper.value);
    if (nearest == 0) continue;
    const auto [at, placed] =
        start.positions.emplace(scoped_name(root, id), std::array<double, 2>{nearest, 0});
    if (placed) start.moved.push_back(id);
  }
  move_followers(root, start);
  return start;
}

}  // namespace rigor::simulate
