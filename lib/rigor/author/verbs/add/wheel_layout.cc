// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/add/wheel_layout.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include <rigor/robot/assembled/axles.h>

namespace rigor::author {
namespace {

using model::Vector3;

/// An axis this near to another is along it: 8°, more than camber and toe.
constexpr double kAlong = 0.99;
/// Pairs with radius and separation within this share of the largest's drive with it.
constexpr double kAlike = 0.02;

enum class Mount { kFixed, kSteered, kCaster };

struct WheelPair {
  std::string left, right;
  double separation = 0, radius = 0, x = 0;
  Mount mount = Mount::kFixed;
  model::Id<model::Joint> left_mount, right_mount;  ///< joints that steer
};

class LayoutFinder {
 public:
  explicit LayoutFinder(const EditedModel& edited)
      : edited_(edited),
        root_(edited.root()),
        robot_(robot::assemble(root_, edited.frames,
                               [&edited](const model::Mesh& mesh, robot::ShapeRole) {
                                 const mass::MeshSurvey* survey = edited.find_mesh(mesh);
                                 return survey != nullptr && survey->triangles > 0
                                            ? std::optional(survey->bounds)
                                            : std::nullopt;
                               })),
        X_MW_(inverse(edited.frames.pose(edited.model).value_or(model::Pose{}))) {}

  WheelLayout find() {
    find_pairs();
    WheelLayout layout;
    const WheelPair* main = nullptr;
    for (const WheelPair& pair : pairs_) {
      if (pair.mount == Mount::kFixed && (main == nullptr || pair.radius > main->radius))
        main = &pair;
    }
    if (main == nullptr) {
      layout.problem = across_
                           ? "its wheels roll along y, and drives take x for forward"
                           : "no pair of wheels is found: continuous joints about y whose links "
                             "have round shapes";
      return layout;
    }
    layout.separation = main->separation;
    layout.radius = main->radius;
    for (const WheelPair& pair : pairs_) {
      const bool alike = std::abs(pair.radius - main->radius) <= kAlike * main->radius &&
                         std::abs(pair.separation - main->separation) <= kAlike * main->separation;
      if (pair.mount != Mount::kFixed || !alike) continue;
      layout.left.push_back(pair.left);
      layout.right.push_back(pair.right);
    }
    layout.steering = steering(*main);
    return layout;
  }

 private:
  Vector3 in_model(const Vector3& p_W) const { return transform(X_MW_, p_W); }

  void find_pairs() {
    const std::vector<robot::Wheel> wheels = robot::wheels(root_, edited_.frames, robot_);
    for (const robot::Axle& axle : robot::axles(wheels, robot_)) {
      const robot::Wheel* left = &wheels[axle.a];
      const robot::Wheel* right = &wheels[axle.b];
      if (!edited_.inside(root_.joints[left->joint].model)) continue;
      const double along_y = std::abs(rotate(X_MW_.rotation, left->axis_W).y);
      if (along_y < kAlong) {
        across_ = true;
        continue;
      }
      Vector3 l = in_model(left->center_W), r = in_model(right->center_W);
      if (l.y < r.y) {
        std::swap(left, right);
        std::swap(l, r);
      }
      WheelPair pair;
      pair.left = edited_.name_of(model::Id<model::Joint>{left->joint});
      pair.right = edited_.name_of(model::Id<model::Joint>{right->joint});
      pair.separation = l.y - r.y;
      pair.radius = left->radius();
      pair.x = l.x;
      pair.left_mount = mount_of(left->joint);
      pair.right_mount = mount_of(right->joint);
      if (pair.left_mount && pair.right_mount) {
        const bool free = robot::turns_on_and_on(root_[pair.left_mount]);
        pair.mount = free ? Mount::kCaster : Mount::kSteered;
      }
      pairs_.push_back(pair);
    }
    nearest_only();
  }

  /// Of twin wheels and of wheels behind each other each is in one pair, with the outermost.
  void nearest_only() {
    std::stable_sort(pairs_.begin(), pairs_.end(), [](const WheelPair& a, const WheelPair& b) {
      return a.separation > b.separation;
    });
    std::vector<WheelPair> kept;
    for (const WheelPair& pair : pairs_) {
      const bool taken = std::any_of(kept.begin(), kept.end(), [&](const WheelPair& other) {
        return other.left == pair.left || other.right == pair.right || other.left == pair.right ||
               other.right == pair.left;
      });
      if (!taken) kept.push_back(pair);
    }
    std::stable_sort(kept.begin(), kept.end(),
                     [](const WheelPair& a, const WheelPair& b) { return a.x > b.x; });
    pairs_ = std::move(kept);
  }

  /// The upright joint that carries what carries the wheel; none where it is fixed.
  model::Id<model::Joint> mount_of(std::uint32_t wheel_joint) const {
    model::Id<model::Link> link = edited_.frames.ends({wheel_joint}).parent;
    for (std::size_t i = 0; link && i < root_.joints.size(); ++i) {
      const model::Id<model::Joint> carrier = robot_.links[link.value].carrier;
      if (!carrier) return {};
      const model::Joint& joint = root_[carrier];
      const auto axis_W = edited_.frames.axis(carrier, 0);
      const bool turns =
          joint.type == model::JointType::kRevolute || joint.type == model::JointType::kContinuous;
      if (turns && axis_W && std::abs(rotate(X_MW_.rotation, *axis_W).z) > kAlong) return carrier;
      link = edited_.frames.ends(carrier).parent;
    }
    return {};
  }

  std::optional<SteeringLayout> steering(const WheelPair& main) const {
    for (const WheelPair& pair : pairs_) {
      if (pair.mount != Mount::kSteered || pair.left_mount == pair.right_mount) continue;
      const auto X_WL = edited_.frames.pose(pair.left_mount);
      const auto X_WR = edited_.frames.pose(pair.right_mount);
      if (!X_WL || !X_WR) continue;
      SteeringLayout steering;
      steering.left = edited_.name_of(pair.left_mount);
      steering.right = edited_.name_of(pair.right_mount);
      steering.kingpin = in_model(X_WL->translation).y - in_model(X_WR->translation).y;
      steering.wheel_base = std::abs(pair.x - main.x);
      const model::Axis& axis = root_[pair.left_mount].axes.front();
      steering.limit = std::min(std::abs(axis.lower.value), std::abs(axis.upper.value));
      return steering;
    }
    return std::nullopt;
  }

  const EditedModel& edited_;
  const model::Root& root_;
  robot::Assembled robot_;
  model::Pose X_MW_;
  std::vector<WheelPair> pairs_;
  bool across_ = false;
};

}  // namespace

WheelLayout wheel_layout(const EditedModel& edited) { return LayoutFinder(edited).find(); }

}  // namespace rigor::author
