// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a joint has to hold: the weight of all that it moves, as a torque about its axis.
//
//   GravityLoads loads(context);
//   if (const auto most = loads.most({3})) compare(effort, *most);

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include <rigor/mass/mass_properties.h>
#include <rigor/mass/resolve.h>
#include <rigor/model/model.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// Of one file's joints. Gravity is along -z of the model or world, 9.8 m/s², and all other joints are at zero.
class GravityLoads {
 public:
  explicit GravityLoads(const Context& context) : context_(context) {
    const model::Root& root = context.root();
    for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
      const auto& ends = context.frames().ends({i});
      if (ends.parent && ends.child) children_[ends.parent.value].push_back(ends.child);
    }
  }

  /// N·m, N of a prismatic joint: the largest while the joint turns once around. Nothing when a pose or a
  /// mass is not known, or the links behind the joint are too many or make a loop.
  std::optional<double> most(model::Id<model::Joint> id) const {
    const model::Root& root = context_.root();
    const auto child = context_.frames().ends(id).child;
    const auto axis = context_.frames().axis(id, 0);
    const auto X_WJ = context_.frames().pose(id);
    if (!child || !axis || !X_WJ) return std::nullopt;
    const auto moved = behind(child);
    if (!moved) return std::nullopt;
    const double weight = moved->mass * kGravity;
    if (root[id].type == model::JointType::kPrismatic) return weight * std::abs(axis->z);
    const model::Vector3 arm = moved->com - X_WJ->translation;
    const double radius = length(arm - dot(arm, *axis) * *axis);
    return weight * radius * std::sqrt(std::max(0.0, 1 - axis->z * axis->z));
  }

 private:
  static constexpr double kGravity = 9.8;
  static constexpr std::size_t kMaxLinks = 200;  // a chain that is longer is no arm

  std::optional<mass::MassProperties> behind(model::Id<model::Link> child) const {
    std::vector<model::Id<model::Link>> all{child};
    mass::MassProperties sum;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all.size() > kMaxLinks) return std::nullopt;
      const auto X_WL = context_.frames().pose(all[i]);
      if (!X_WL || mass::is_automatic(context_.root()[all[i]])) return std::nullopt;
      sum = mass::add(sum, mass::transformed(*X_WL, mass::resolve(context_.root(), all[i])));
      const auto below = children_.find(all[i].value);
      if (below != children_.end())
        all.insert(all.end(), below->second.begin(), below->second.end());
    }
    return sum.mass > 0 && std::isfinite(sum.mass) ? std::optional(sum) : std::nullopt;
  }

  const Context& context_;
  std::unordered_map<std::uint32_t, std::vector<model::Id<model::Link>>> children_;
};

}  // namespace rigor::rules
