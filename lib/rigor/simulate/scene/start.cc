// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/start.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rigor::simulate {
namespace {

/// Nothing when the joint has no limits, or none that a place fits between.
const model::Axis* axis_with_limits(const model::Joint& joint) {
  const bool limited =
      joint.type == model::JointType::kRevolute || joint.type == model::JointType::kPrismatic;
  if (!limited || joint.axes.empty()) return nullptr;
  const model::Axis& axis = joint.axes[0];
  return axis.limit_written && axis.lower.value <= axis.upper.value ? &axis : nullptr;
}

/// Followers that nobody placed, where their leaders' places put them, as far as their own stops let them: those of
/// followers in turn, and those of a cycle nowhere.
class Followers {
 public:
  Followers(const model::Root& root, model::JointPositions& positions)
      : root_(root), positions_(positions) {
    for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
      const model::Joint& joint = root.joints[i];
      const bool follows = !joint.axes.empty() && joint.axes[0].mimic;
      std::string name = scoped_name(root, model::Id<model::Joint>{i});
      const bool is_open = follows && !positions.contains(name);
      (is_open ? open_ : placed_).emplace(std::move(name), &joint);
    }
  }

  void place() {
    while (!open_.empty()) {
      std::vector<Joints::node_type> row;  // each follows the next
      std::string leader = open_.begin()->first;
      for (auto node = open_.extract(leader); !node.empty(); node = open_.extract(leader)) {
        leader = scoped_name(root_, node.mapped()->model) +
                 "::" + node.mapped()->axes[0].mimic->joint.value;
        row.push_back(std::move(node));
      }
      if (!placed_.contains(leader)) continue;
      const auto known = positions_.find(leader);
      double at = known == positions_.end() ? 0 : known->second[0];
      for (auto node = row.rbegin(); node != row.rend(); ++node) {
        at = place_of(*node->mapped(), at);
        positions_.emplace(node->key(), std::array<double, 2>{at, 0});
        placed_.insert(std::move(*node));
      }
    }
  }

 private:
  using Joints = std::unordered_map<std::string, const model::Joint*>;  // by scoped name

  static double place_of(const model::Joint& joint, double leader) {
    const model::Mimic& mimic = *joint.axes[0].mimic;
    const double place = mimic.multiplier.value * leader + mimic.offset.value;
    const model::Axis* limits = axis_with_limits(joint);
    return limits ? std::clamp(place, limits->lower.value, limits->upper.value) : place;
  }

  const model::Root& root_;
  model::JointPositions& positions_;
  Joints placed_, open_;
};

}  // namespace

Start start_within_limits(const model::Root& root, model::JointPositions positions) {
  Start start{std::move(positions), {}};
  if (root.format != model::Format::kUrdf) return start;
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const model::Id<model::Joint> id{i};
    const model::Axis* axis = axis_with_limits(root[id]);
    if (axis == nullptr || axis->mimic) continue;
    const double nearest = std::clamp(0.0, axis->lower.value, axis->upper.value);
    if (nearest == 0) continue;
    const auto [at, placed] =
        start.positions.emplace(scoped_name(root, id), std::array<double, 2>{nearest, 0});
    if (placed) start.moved.push_back(id);
  }
  Followers(root, start.positions).place();
  return start;
}

}  // namespace rigor::simulate
