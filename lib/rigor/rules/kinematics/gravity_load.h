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
#include <limits>
#include <optional>
#include <vector>

#include <rigor/mass/resolve.h>
#include <rigor/model/model.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// Of one file's joints. Gravity is along -z of the model or world, 9.8 m/s², and all other joints are at zero.
/// What is behind the joints is added up once for all, from the ends of the tree.
class GravityLoads {
 public:
  explicit GravityLoads(const Context& context)
      : context_(context), behind_(context.root().links.size()) {
    std::vector<std::uint32_t> parent(behind_.size(), kNone);
    std::vector<std::uint32_t> open(behind_.size(), 0);  // children that are not added yet
    for (std::uint32_t i = 0; i < context.root().joints.size(); ++i) {
      const auto& ends = context.frames().ends({i});
      if (!ends.parent || !ends.child) continue;
      std::uint32_t& carrier = parent[ends.child.value];
      if (carrier != kNone) {
        // Which of two joints bears a link is not known.
        behind_[ends.child.value].known = false;
        behind_[carrier].known = false;
      }
      carrier = ends.parent.value;
    }
    for (const std::uint32_t of : parent) {
      if (of != kNone) ++open[of];
    }
    std::vector<std::uint32_t> ready;
    for (std::uint32_t i = 0; i < open.size(); ++i) {
      if (open[i] == 0) ready.push_back(i);
    }
    while (!ready.empty()) {
      const std::uint32_t link = ready.back();
      ready.pop_back();
      add_own({link});
      behind_[link].done = true;
      const std::uint32_t to = parent[link];
      if (to == kNone) continue;
      add(behind_[link], behind_[to]);
      if (--open[to] == 0) ready.push_back(to);
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
    const Behind& moved = behind_[child.value];
    if (!moved.done || !moved.known || moved.links > kMaxLinks || !(moved.mass > 0) ||
        !std::isfinite(moved.mass))
      return std::nullopt;
    const double weight = moved.mass * kGravity;
    if (root[id].type == model::JointType::kPrismatic) return weight * std::abs(axis->z);
    const model::Vector3 arm = (1 / moved.mass) * moved.first_moment_W - X_WJ->translation;
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
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// A link and all that it carries.
  struct Behind {
    double mass = 0;                ///< kg
    model::Vector3 first_moment_W;  ///< kg·m, of the masses about the origin of W
    std::size_t links = 0;
    bool known = true;  ///< whether all poses and masses are, and there is no loop
    bool done = false;  ///< whether all that it carries is added: not in a cycle
  };

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

  static void add(const Behind& from, Behind& to) {
    to.mass += from.mass;
    to.first_moment_W = to.first_moment_W + from.first_moment_W;
    to.links += from.links;
    to.known = to.known && from.known;
  }

  void add_own(model::Id<model::Link> link) {
    const auto X_WL = context_.frames().pose(link);
    Behind own{.links = 1};
    own.known = X_WL && !mass::is_automatic(context_.root()[link]);
    if (own.known) {
      const mass::MassProperties body = mass::resolve(context_.root(), link);
      own.mass = body.mass;
      own.first_moment_W = body.mass * transform(*X_WL, body.com);
    }
    add(own, behind_[link.value]);
  }

  const Context& context_;
  std::vector<Behind> behind_;  // by the link's index
};

}  // namespace rigor::rules
