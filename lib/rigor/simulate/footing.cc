// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/footing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include <rigor/simulate/model_groups.h>
#include <rigor/simulate/reach.h>

namespace rigor::simulate {
namespace {

/// s: a fall that is over by then leaves as long again to come to rest in, before rest is judged.
constexpr double kShortFall = 0.4;

/// m: what touches along its edge is below.
constexpr double kFootingSlack = 0.001;

/// How far something reaches along two level directions and upward.
struct FootingBounds {
  std::array<double, 3> least{kInfinity, kInfinity, kInfinity};
  std::array<double, 3> most{-kInfinity, -kInfinity, -kInfinity};

  void add(const FootingBounds& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      least[i] = std::min(least[i], other.least[i]);
      most[i] = std::max(most[i], other.most[i]);
    }
  }
  double bottom() const { return least[2]; }
  double top() const { return most[2]; }
  bool is_over(const FootingBounds& other) const {
    for (std::size_t i = 0; i < 2; ++i) {
      if (least[i] > other.most[i] + kFootingSlack || other.least[i] > most[i] + kFootingSlack) {
        return false;
      }
    }
    return other.bottom() < top();
  }
};

class FootingFinder {
 public:
  explicit FootingFinder(const Scene& scene)
      : scene_(scene),
        groups_(scene),
        bounds_(scene.models.size()),
        gaps_(scene.models.size(), kInfinity) {
    up_ = -1 / length(scene.gravity) * scene.gravity;
    const Vector3 aside = std::abs(up_.z) < 0.9 ? Vector3{0, 0, 1} : Vector3{1, 0, 0};
    const Vector3 across = cross(up_, aside);
    axes_ = {1 / length(across) * across, cross(up_, across), up_};
    axes_[1] = 1 / length(axes_[1]) * axes_[1];
  }

  std::vector<Footing> find() {
    take_bounds();
    while (support_once()) {
    }
    std::vector<Footing> footings(scene_.models.size());
    for (std::uint32_t m = 0; m < footings.size(); ++m) {
      const std::uint32_t root = groups_.root(m);
      if (scene_.models[m].is_static) continue;
      if (groups_.held(root)) {
        footings[m].kind = Footing::Kind::kHangs;
      } else if (!stands(root)) {
        footings[m] = {Footing::Kind::kInTheAir, gaps_[root]};
      }
    }
    return footings;
  }

 private:
  bool stands(std::uint32_t root) const {
    return groups_.held(root) ||
           gaps_[root] <= length(scene_.gravity) * kShortFall * kShortFall / 2;
  }

  FootingBounds around(const Vector3& p) const {
    FootingBounds bounds;
    for (std::size_t i = 0; i < 3; ++i) bounds.least[i] = bounds.most[i] = dot(p, axes_[i]);
    return bounds;
  }

  FootingBounds bounds_of_shape(const SceneShape& shape) const {
    FootingBounds bounds;
    for (std::size_t i = 0; i < 3; ++i) {
      bounds.least[i] = -reach(scene_, shape, -1 * axes_[i]);
      bounds.most[i] = reach(scene_, shape, axes_[i]);
    }
    return bounds;
  }

  /// What stands from the start is support; of what moves, groups have their bounds.
  void take_bounds() {
    for (const SceneBody& body : scene_.bodies) {
      bounds_[groups_.root(body.model)].add(around(transform(body.X_WB, body.mass.com)));
    }
    for (const SceneShape& shape : scene_.shapes) {
      if (std::holds_alternative<HalfSpace>(shape.kind)) {
        planes_.push_back(&shape);
        continue;
      }
      if (std::holds_alternative<HeightGrid>(shape.kind)) {
        lands_.push_back(&shape);
        continue;
      }
      const FootingBounds bounds = bounds_of_shape(shape);
      if (shape.body == kWorld) {
        support_.push_back(bounds);
      } else {
        bounds_[groups_.root(scene_.bodies[shape.body].model)].add(bounds);
      }
    }
    for (std::uint32_t m = 0; m < bounds_.size(); ++m) {
      if (groups_.root(m) != m || bounds_[m].bottom() == kInfinity) continue;
      if (groups_.held(m)) {
        support_.push_back(bounds_[m]);
      } else {
        open_.push_back(m);
        fall_on_planes(m);
        fall_on_lands(m);
      }
    }
  }

  /// Straight down, from the lowest point of the middle of its bounds.
  void fall_on_planes(std::uint32_t root) {
    const FootingBounds& own = bounds_[root];
    Vector3 foot = own.bottom() * axes_[2];
    for (std::size_t i = 0; i < 2; ++i) foot = foot + (own.least[i] + own.most[i]) / 2 * axes_[i];
    for (const SceneShape* plane : planes_) {
      const Pose X_WS = start_pose(scene_, *plane);
      const Vector3 n = rotate(X_WS.rotation, std::get<HalfSpace>(plane->kind).normal);
      if (!(dot(n, up_) > 0)) continue;
      const double gap = dot(n, foot - X_WS.translation) / dot(n, up_);
      gaps_[root] = std::min(gaps_[root], std::max(0.0, gap));
    }
  }

  /// On the highest point of the land under its bounds. Land is level but for its heights: that which was
  /// put up as a wall is not examined.
  void fall_on_lands(std::uint32_t root) {
    for (const SceneShape* land : lands_) {
      const auto& grid = std::get<HeightGrid>(land->kind);
      FootingBounds local;  // along the grid's own axes
      for (int i = 0; i < 4; ++i) {
        const FootingBounds& own = bounds_[root];
        const Vector3 corner = ((i & 1) != 0 ? own.least[0] : own.most[0]) * axes_[0] +
                               ((i & 2) != 0 ? own.least[1] : own.most[1]) * axes_[1] +
                               own.bottom() * axes_[2];
        const Vector3 p = transform(inverse(start_pose(scene_, *land)), corner);
        local.add({{p.x, p.y, p.z}, {p.x, p.y, p.z}});
      }
      const double top = highest_in(grid, local);
      gaps_[root] = std::min(gaps_[root], std::max(0.0, local.bottom() - top));
    }
  }

  /// m; minus infinity where the bounds are beside it.
  static double highest_in(const HeightGrid& grid, const FootingBounds& bounds) {
    const auto range = [&](std::size_t axis, double size, std::uint32_t count) {
      const double cell = size / (count - 1);
      const double last = count - 1.0;
      const double begin = std::floor((bounds.least[axis] + size / 2) / cell);
      const double end = std::ceil((bounds.most[axis] + size / 2) / cell);
      if (end < 0 || begin > last) return std::pair<std::size_t, std::size_t>{1, 0};
      return std::pair{static_cast<std::size_t>(std::max(0.0, begin)),
                       static_cast<std::size_t>(std::min(last, end))};
    };
    const auto [left, right] = range(0, grid.width, grid.columns);
    const auto [near, far] = range(1, grid.depth, grid.rows);
    double highest = -kInfinity;
    for (std::size_t row = near; row <= far; ++row) {
      for (std::size_t column = left; column <= right; ++column) {
        highest = std::max(highest, grid.heights[row * grid.columns + column]);
      }
    }
    return highest;
  }

  /// Whether a group was found to stand that was not known to: others may stand on it.
  bool support_once() {
    const std::size_t known = support_.size();
    std::vector<std::uint32_t> still_open;
    for (const std::uint32_t root : open_) {
      const FootingBounds& own = bounds_[root];
      for (std::size_t i = seen_; i < known && !stands(root); ++i) {
        if (!own.is_over(support_[i])) continue;
        gaps_[root] = std::min(gaps_[root], std::max(0.0, own.bottom() - support_[i].top()));
      }
      if (stands(root)) {
        support_.push_back(own);
      } else {
        still_open.push_back(root);
      }
    }
    seen_ = known;
    open_ = std::move(still_open);
    return support_.size() > known;
  }

  const Scene& scene_;
  ModelGroups groups_;
  Vector3 up_;
  std::array<Vector3, 3> axes_;
  std::vector<FootingBounds> bounds_;  // by the group's root
  std::vector<double> gaps_;           // likewise
  std::vector<FootingBounds> support_;
  std::size_t seen_ = 0;  // of the support, what all that is open was held against
  std::vector<std::uint32_t> open_;
  std::vector<const SceneShape*> planes_;
  std::vector<const SceneShape*> lands_;
};

/// By a command that the joint has an effort for.
bool is_held(const Scene& scene, const Scenario& scenario, std::uint32_t joint) {
  const std::vector<SceneAxis>& axes = scene.joints[joint].axes;
  return std::any_of(scenario.commands.begin(), scenario.commands.end(),
                     [&](const Command& command) {
                       return command.joint == joint && command.kind != CommandKind::kEffort &&
                              (command.axis >= axes.size() || axes[command.axis].effort > 0);
                     });
}

}  // namespace

std::vector<Footing> footings_of(const Scene& scene) {
  if (!scene.alone && length(scene.gravity) > 0) return FootingFinder(scene).find();
  std::vector<Footing> footings(scene.models.size());
  const ModelGroups groups(scene);
  for (std::uint32_t m = 0; m < footings.size(); ++m) {
    const bool hangs = !scene.models[m].is_static && groups.held(groups.root(m));
    if (hangs) footings[m].kind = Footing::Kind::kHangs;
  }
  return footings;
}

std::vector<bool> moving_freely(const Scene& scene, const Scenario& scenario) {
  std::vector<bool> free(scene.bodies.size());
  if (scene.models.empty()) return free;
  const std::vector<Footing> footings = footings_of(scene);
  const ModelGroups groups(scene);
  std::vector<bool> loose(scene.models.size());  // by the group's root
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    const std::uint32_t body = joint.child == kWorld ? joint.parent : joint.child;
    if (body >= scene.bodies.size() || !joint.mimics.empty()) continue;
    const bool can_move =
        joint.type != model::JointType::kFixed && joint.type != model::JointType::kGearbox;
    if (can_move && !is_held(scene, scenario, j))
      loose[groups.root(scene.bodies[body].model)] = true;
  }
  for (std::size_t b = 0; b < free.size(); ++b) {
    const std::uint32_t model = scene.bodies[b].model;
    const Footing::Kind kind = footings[model].kind;
    free[b] = kind == Footing::Kind::kInTheAir ||
              (kind == Footing::Kind::kHangs && loose[groups.root(model)]);
  }
  return free;
}

}  // namespace rigor::simulate
