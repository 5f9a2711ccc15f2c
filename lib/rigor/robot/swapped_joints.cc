// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/swapped_joints.h>

#include <algorithm>
#include <optional>

#include <rigor/text/disjoint_sets.h>

namespace rigor::robot {
namespace {

/// Joints on the ways that are examined, all together: robots have a few thousand at most, and a file
/// that is made to have longer ones keeps them as they are.
constexpr std::size_t kMaxSteps = 1'000'000;

class EdgeDirector {
 public:
  EdgeDirector(const std::vector<Edge>& edges, std::size_t bodies, std::uint32_t world)
      : edges_(edges),
        world_(world),
        carrier_(bodies, kNoIndex),
        trees_(bodies),
        directions_(edges.size(), Edge::Direction::kLeftOut) {}

  std::vector<Edge::Direction> directions() && {
    std::vector<std::uint32_t> second_parents;
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      const auto& [parent, child, turns] = edges_[i];
      if (carrier_[child] != kNoIndex) {
        second_parents.push_back(i);
      } else if (trees_.find(parent) != trees_.find(child)) {
        add(i, Edge::Direction::kAsWritten);
      }
    }
    for (const std::uint32_t i : second_parents) {
      if (trees_.find(edges_[i].parent) != trees_.find(edges_[i].child)) join_trees(i);
    }
    return std::move(directions_);
  }

 private:
  void add(std::uint32_t i, Edge::Direction direction) {
    const auto& [parent, child, turns] = edges_[i];
    directions_[i] = direction;
    carrier_[direction == Edge::Direction::kTurned ? parent : child] = i;
    trees_.join(parent, child);
  }

  /// The joints from a body up to the root of its tree; nothing where one cannot be turned, or the root
  /// is the world.
  std::optional<std::vector<std::uint32_t>> way_up(std::uint32_t body) {
    if (world_ != kNoIndex && trees_.find(body) == trees_.find(world_)) return std::nullopt;
    std::vector<std::uint32_t> way;
    while (carrier_[body] != kNoIndex) {
      const std::uint32_t i = carrier_[body];
      if (!edges_[i].can_turn || ++steps_ > kMaxSteps) return std::nullopt;
      way.push_back(i);
      body = edges_[i].parent == body ? edges_[i].child : edges_[i].parent;
    }
    return way;
  }

  /// Makes the body at its beginning the root.
  void turn(std::uint32_t body, const std::vector<std::uint32_t>& way) {
    carrier_[body] = kNoIndex;
    for (const std::uint32_t i : way) {
      const bool turned = directions_[i] == Edge::Direction::kTurned;
      directions_[i] = turned ? Edge::Direction::kAsWritten : Edge::Direction::kTurned;
      carrier_[turned ? edges_[i].child : edges_[i].parent] = i;
    }
  }

  /// The parent's tree is hung on the child, or the child's on the parent: whichever turns less.
  void join_trees(std::uint32_t i) {
    const auto& [parent, child, turns] = edges_[i];
    const auto above_parent = turns ? way_up(parent) : std::nullopt;
    if (above_parent && above_parent->empty()) return add(i, Edge::Direction::kTurned);
    const auto above_child = way_up(child);
    if (above_parent && (!above_child || above_parent->size() < above_child->size())) {
      turn(parent, *above_parent);
      add(i, Edge::Direction::kTurned);
    } else if (above_child) {
      turn(child, *above_child);
      add(i, Edge::Direction::kAsWritten);
    }
  }

  const std::vector<Edge>& edges_;
  std::uint32_t world_;
  std::vector<std::uint32_t> carrier_;  // of each body
  DisjointSets trees_;                  // of bodies
  std::vector<Edge::Direction> directions_;
  std::size_t steps_ = 0;
};

}  // namespace

std::vector<Edge::Direction> edge_directions(const std::vector<Edge>& edges, std::size_t bodies,
                                             std::uint32_t world) {
  return EdgeDirector(edges, bodies, world).directions();
}

bool can_turn(model::JointType type) {
  return type != model::JointType::kUniversal && type != model::JointType::kRevolute2;
}

}  // namespace rigor::robot
