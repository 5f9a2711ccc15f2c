// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <rigor/robot/static_loads.h>

#include <rigor/robot/random.h>

namespace rigor::robot {
namespace {

using model::Pose;
using model::Vector3;

// Each of n axes tries n joints at a time, and each try walks all n: beyond, samples must do.
constexpr std::size_t kMaxRaisedJoints = 100;
constexpr int kMaxRounds = 50;  // each closes in by a factor; robots take 3 to 20

/// A force through a point, by its moment about the origin.
struct Weight {
  Vector3 force;   // N
  Vector3 moment;  // N·m
};

/// Of each body with all that it carries.
std::vector<Weight> carried_weights(const Robot& robot, const std::vector<Pose>& X_MB,
                                    const Vector3& gravity_M) {
  std::vector<Weight> weights(robot.bodies.size());
  for (auto i = robot.order.rbegin(); i != robot.order.rend(); ++i) {
    const Body& body = robot.bodies[*i];
    Weight& weight = weights[*i];
    const Vector3 force = body.mass.mass * gravity_M;
    weight.force = weight.force + force;
    weight.moment = weight.moment + cross(transform(X_MB[*i], body.mass.com), force);
    if (body.carrier == kNoIndex) continue;
    Weight& below = weights[robot.joints[body.carrier].parent];
    below.force = below.force + weight.force;
    below.moment = below.moment + weight.moment;
  }
  return weights;
}

double holding_effort(const Axis& axis, const Pose& X_MA, const Weight& weight) {
  const Vector3 n = rotate(X_MA.rotation, axis.direction);
  const double along = -dot(n, weight.force);
  if (axis.motion == Axis::Motion::kSlide) return along;
  const double about = -dot(n, weight.moment - cross(X_MA.translation, weight.force));
  return axis.motion == Axis::Motion::kScrew ? about + axis.slide * along : about;
}

/// Adds what followers bear to their leaders, the last of a row first.
void pass_to_leaders(const Robot& robot, Efforts& efforts) {
  std::unordered_map<std::string_view, std::size_t> by_name;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) by_name.emplace(robot.joints[j].name, j);
  const std::size_t rounds = robot.joints.size();
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    for (std::size_t k = 0; k < robot.joints[j].axes.size(); ++k) {
      double effort = std::exchange(efforts[j][k], 0);
      std::size_t joint = j, axis = k, steps = 0;
      while (const auto& follow = robot.joints[joint].axes[axis].follow) {
        const auto leader = by_name.find(follow->joint);
        if (leader == by_name.end() || ++steps > rounds) break;
        if (follow->axis >= robot.joints[leader->second].axes.size()) break;
        effort *= follow->multiplier;
        joint = leader->second;
        axis = follow->axis;
      }
      efforts[joint][axis] += effort;
    }
  }
}

struct Range {
  double lower = 0, upper = 0;
  double clamped(double q) const { return std::clamp(q, lower, upper); }
};

Range range_of(const Axis& axis) {
  const double open = axis.motion == Axis::Motion::kSlide ? 0 : std::numbers::pi;
  Range range{std::isfinite(axis.lower) ? axis.lower : -open,
              std::isfinite(axis.upper) ? axis.upper : open};
  if (range.upper < range.lower) range.upper = range.lower;
  return range;
}

struct FreeAxis {
  std::uint32_t joint = 0, axis = 0;
  Range range;
};

class LoadSearch {
 public:
  LoadSearch(const Robot& robot, const LoadRequest& request) : robot_(robot), request_(request) {
    for (std::uint32_t j = 0; j < robot.joints.size(); ++j) {
      result_.has_loops = result_.has_loops || robot.joints[j].closes_loop;
      zero_.emplace_back(robot.joints[j].axes.size());
      if (robot.joints[j].closes_loop) continue;
      for (std::uint32_t k = 0; k < robot.joints[j].axes.size(); ++k) {
        const Axis& axis = robot.joints[j].axes[k];
        has_followers_ = has_followers_ || axis.follow;
        if (!axis.follow && length(axis.direction) > 0) free_.push_back({j, k, range_of(axis)});
      }
    }
  }

  StaticLoads run() {
    for (const FreeAxis& free : free_) {
      const double limit = robot_.joints[free.joint].axes[free.axis].effort;
      result_.axes.push_back({free.joint, free.axis, 0, limit, zero_});
    }
    Random random(request_.seed);
    Positions positions = zero_;
    for (const FreeAxis& free : free_) at(positions, free) = free.range.clamped(0);
    for (std::size_t i = 0; i <= request_.samples; ++i) {
      try_out(positions);
      for (const FreeAxis& free : free_) {
        at(positions, free) = random.between(free.range.lower, free.range.upper);
      }
    }
    if (free_.size() <= kMaxRaisedJoints) {
      for (std::size_t i = 0; i < free_.size(); ++i) raise(i);
    }
    return std::move(result_);
  }

 private:
  static double& at(Positions& positions, const FreeAxis& free) {
    return positions[free.joint][free.axis];
  }

  Positions whole(const Positions& positions) const {
    return has_followers_ ? followed(robot_, positions) : positions;
  }

  Efforts efforts(const Positions& positions) const {
    return holding_efforts(robot_, whole(positions), request_.gravity_M);
  }

  void try_out(const Positions& positions) {
    const Efforts found = efforts(positions);
    for (AxisLoad& load : result_.axes) {
      const double effort = found[load.joint][load.axis];
      if (std::abs(effort) > std::abs(load.effort)) {
        load.effort = effort;
        load.at = positions;
      }
    }
    extend(body_poses(robot_, whole(positions)));
  }

  void extend(const std::vector<Pose>& X_MB) {
    const auto add = [this](const Vector3& p) {
      if (!result_.reach) result_.reach = Reach{p, p};
      Reach& reach = *result_.reach;
      reach.min = {std::min(reach.min.x, p.x), std::min(reach.min.y, p.y),
                   std::min(reach.min.z, p.z)};
      reach.max = {std::max(reach.max.x, p.x), std::max(reach.max.y, p.y),
                   std::max(reach.max.z, p.z)};
    };
    for (std::size_t i = 0; i < X_MB.size(); ++i) {
      if (robot_.bodies[i].name == kWorldBody) continue;
      add(X_MB[i].translation);
      if (robot_.bodies[i].mass.mass > 0) add(transform(X_MB[i], robot_.bodies[i].mass.com));
    }
  }

  /// Whether the joint turns what the other carries, or is carried by it: else one's load does not depend
  /// on the other's position.
  bool is_on_one_branch(std::uint32_t a, std::uint32_t b) const {
    const auto carries = [this](std::uint32_t above, std::uint32_t joint) {
      while (joint != kNoIndex && joint != above) {
        joint = robot_.bodies[robot_.joints[joint].parent].carrier;
      }
      return joint == above;
    };
    return has_followers_ || carries(a, b) || carries(b, a);
  }

  /// Moves one joint after the other to where the load is largest, as long as that helps.
  void raise(std::size_t index) {
    AxisLoad& load = result_.axes[index];
    std::vector<FreeAxis> branch;
    std::copy_if(free_.begin(), free_.end(), std::back_inserter(branch),
                 [&](const FreeAxis& free) { return is_on_one_branch(free.joint, load.joint); });
    for (int round = 0; round < kMaxRounds; ++round) {
      const double before = std::abs(load.effort);
      for (const FreeAxis& free : branch) raise_by(free, load);
      if (std::abs(load.effort) <= before * (1 + 1e-12)) return;
    }
  }

  void raise_by(const FreeAxis& free, AxisLoad& load) const {
    Positions positions = load.at;
    const auto effort_at = [&](double q) {
      at(positions, free) = q;
      return efforts(positions)[load.joint][load.axis];
    };
    std::vector<double> candidates{free.range.lower, free.range.upper};
    if (robot_.joints[free.joint].axes[free.axis].motion == Axis::Motion::kTurn) {
      // f(0) = a + b, f(π) = a − b, f(π/2) = a + c; extremes where tan q = c / b.
      const double zero = effort_at(0), half = effort_at(std::numbers::pi);
      const double b = (zero - half) / 2;
      const double c = effort_at(std::numbers::pi / 2) - (zero + half) / 2;
      const double peak = std::atan2(c, b);
      for (int turn = -3; turn <= 3; ++turn) {
        candidates.push_back(free.range.clamped(peak + turn * std::numbers::pi));
      }
    }
    for (const double q : candidates) {
      const double effort = effort_at(q);
      if (std::abs(effort) <= std::abs(load.effort)) continue;
      load.effort = effort;
      load.at = positions;
    }
  }

  const Robot& robot_;
  const LoadRequest& request_;
  Positions zero_;
  std::vector<FreeAxis> free_;
  bool has_followers_ = false;
  StaticLoads result_;
};

}  // namespace

Efforts holding_efforts(const Robot& robot, const Positions& positions, const Vector3& gravity_M) {
  const std::vector<Pose> X_MB = body_poses(robot, positions);
  const std::vector<Weight> weights = carried_weights(robot, X_MB, gravity_M);
  Efforts efforts(robot.joints.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    efforts[j].resize(joint.axes.size());
    if (joint.closes_loop) continue;
    Pose X_MA = compose(X_MB[joint.parent], joint.X_PJ);
    for (std::size_t k = 0; k < joint.axes.size(); ++k) {
      efforts[j][k] = holding_effort(joint.axes[k], X_MA, weights[joint.child]);
      const bool is_given = j < positions.size() && k < positions[j].size();
      if (is_given) X_MA = compose(X_MA, motion(joint.axes[k], positions[j][k]));
    }
  }
  pass_to_leaders(robot, efforts);
  return efforts;
}

StaticLoads static_loads(const Robot& robot, const LoadRequest& request) {
  return LoadSearch(robot, request).run();
}

}  // namespace rigor::robot
