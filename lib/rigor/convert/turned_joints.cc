// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/turned_joints.h>

#include <algorithm>
#include <numeric>
#include <optional>

namespace rigor::convert {
namespace {

/// Joints on the ways that are looked at, all together: robots have a few thousand at most, and a file
/// that is made to have longer ones keeps them as they are.
constexpr std::size_t kMostSteps = 1'000'000;

class LimbHanger {
 public:
  LimbHanger(const std::vector<Limb>& limbs, std::size_t bodies, std::uint32_t world)
      : limbs_(limbs),
        world_(world),
        carrier_(bodies, kNoIndex),
        up_(bodies),
        hangs_(limbs.size(), Limb::Hang::kLeftOut) {
    std::iota(up_.begin(), up_.end(), 0U);
  }

  std::vector<Limb::Hang> hang() && {
    std::vector<std::uint32_t> second_parents;
    for (std::uint32_t i = 0; i < limbs_.size(); ++i) {
      const auto& [parent, child, turns] = limbs_[i];
      if (carrier_[child] != kNoIndex) {
        second_parents.push_back(i);
      } else if (group(parent) != group(child)) {
        add(i, Limb::Hang::kAsWritten);
      }
    }
    for (const std::uint32_t i : second_parents) {
      if (group(limbs_[i].parent) != group(limbs_[i].child)) join_trees(i);
    }
    return std::move(hangs_);
  }

 private:
  /// Which bodies hang together (union-find with path halving).
  std::uint32_t group(std::uint32_t at) {
    while (up_[at] != at) at = up_[at] = up_[up_[at]];
    return at;
  }

  void add(std::uint32_t i, Limb::Hang hang) {
    const auto& [parent, child, turns] = limbs_[i];
    hangs_[i] = hang;
    carrier_[hang == Limb::Hang::kTurned ? parent : child] = i;
    up_[group(child)] = group(parent);
  }

  /// The joints from a body up to the root of its tree; nothing where one cannot be turned, or the root
  /// is the world.
  std::optional<std::vector<std::uint32_t>> way_up(std::uint32_t body) {
    if (world_ != kNoIndex && group(body) == group(world_)) return std::nullopt;
    std::vector<std::uint32_t> way;
    while (carrier_[body] != kNoIndex) {
      const std::uint32_t i = carrier_[body];
      if (!limbs_[i].can_turn || ++steps_ > kMostSteps) return std::nullopt;
      way.push_back(i);
      body = limbs_[i].parent == body ? limbs_[i].child : limbs_[i].parent;
    }
    return way;
  }

  /// Makes the body at its beginning the root.
  void turn(std::uint32_t body, const std::vector<std::uint32_t>& way) {
    carrier_[body] = kNoIndex;
    for (const std::uint32_t i : way) {
      const bool turned = hangs_[i] == Limb::Hang::kTurned;
      hangs_[i] = turned ? Limb::Hang::kAsWritten : Limb::Hang::kTurned;
      carrier_[turned ? limbs_[i].child : limbs_[i].parent] = i;
    }
  }

  /// The parent's tree is hung on the child, or the child's on the parent: whichever turns less.
  void join_trees(std::uint32_t i) {
    const auto& [parent, child, turns] = limbs_[i];
    const auto above_parent = turns ? way_up(parent) : std::nullopt;
    if (above_parent && above_parent->empty()) return add(i, Limb::Hang::kTurned);
    const auto above_child = way_up(child);
    if (above_parent && (!above_child || above_parent->size() < above_child->size())) {
      turn(parent, *above_parent);
      add(i, Limb::Hang::kTurned);
    } else if (above_child) {
      turn(child, *above_child);
      add(i, Limb::Hang::kAsWritten);
    }
  }

  const std::vector<Limb>& limbs_;
  std::uint32_t world_;
  std::vector<std::uint32_t> carrier_;  // of each body
  std::vector<std::uint32_t> up_;
  std::vector<Limb::Hang> hangs_;
  std::size_t steps_ = 0;
};

}  // namespace

std::vector<Limb::Hang> hang_limbs(const std::vector<Limb>& limbs, std::size_t bodies,
                                   std::uint32_t world) {
  return LimbHanger(limbs, bodies, world).hang();
}

bool can_turn(model::JointType type) {
  return type != model::JointType::kUniversal && type != model::JointType::kRevolute2;
}

}  // namespace rigor::convert
