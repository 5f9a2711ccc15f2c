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

  /// N·m, N of a prismatic joint: the largest between the joint's limits, all other joints at zero. Nothing
  /// when a pose or a mass is not known, or the links behind the joint are too many or make a loop.
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
    const model::Vector3 weight_W{0, 0, -weight};
    // The torque at q is A cos q + B sin q.
    const double a = dot(*axis, cross(arm, weight_W));
    const double b = dot(*axis, cross(cross(*axis, arm), weight_W));
    return most_of_wave(a, b, root[id]);
  }

 private:
  static constexpr double kGravity = 9.8;
  static constexpr double kPi = 3.14159265358979323846;
  static constexpr std::size_t kMaxLinks = 200;  // a chain that is longer is no arm

  /// The largest |A cos q + B sin q| between the limits.
  static double most_of_wave(double a, double b, const model::Joint& joint) {
    const double peak = std::hypot(a, b);
    const double lower = joint.axes.front().lower.value, upper = joint.axes.front().upper.value;
    if (joint.type != model::JointType::kRevolute || !(upper - lower < kPi)) return peak;
    const double first = std::ceil((lower - std::atan2(b, a)) / kPi) * kPi + std::atan2(b, a);
    if (first <= upper) return peak;
    const auto at = [&](double q) { return std::abs(a * std::cos(q) + b * std::sin(q)); };
    return std::max(at(lower), at(upper));
  }

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
