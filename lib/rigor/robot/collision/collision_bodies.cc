// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/collision/collision_bodies.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace rigor::robot {
namespace {

using mesh::Ball;
using mesh::Collider;
using model::Vector3;

/// Has an end, so that it can be in the way of another link.
bool is_solid(const Shape& shape) {
  return shape.kind != "none" && shape.kind != "plane" && shape.kind != "heightmap" &&
         shape.kind != "image" && shape.kind != "empty";
}

bool are_sizes(const std::vector<double>& numbers, std::size_t count) {
  return numbers.size() >= count &&
         std::all_of(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count),
                     [](double number) { return std::isfinite(number) && number > 0; });
}

std::optional<Collider> primitive(const Shape& shape) {
  const std::vector<double>& n = shape.numbers;
  if (shape.kind == "sphere" && are_sizes(n, 1)) return Collider::sphere(n[0]);
  if (shape.kind == "box" && are_sizes(n, 3)) return Collider::box({n[0], n[1], n[2]});
  if (shape.kind == "ellipsoid" && are_sizes(n, 3)) return Collider::ellipsoid({n[0], n[1], n[2]});
  if (!are_sizes(n, 2)) return std::nullopt;
  if (shape.kind == "cylinder") return Collider::cylinder(n[0], n[1]);
  if (shape.kind == "capsule") return Collider::capsule(n[0], n[1]);
  if (shape.kind == "cone") return Collider::cone(n[0], n[1]);
  return std::nullopt;
}

/// Around both.
Ball joined_balls(const Ball& a, const Ball& b) {
  const Vector3 d = b.center - a.center;
  const double apart = length(d);
  if (apart + b.radius <= a.radius) return a;
  if (apart + a.radius <= b.radius) return b;
  const double radius = (apart + a.radius + b.radius) / 2;
  return {a.center + ((radius - a.radius) / apart) * d, radius};
}

bool balls_touch(const Vector3& a, double radius_a, const Vector3& b, double radius_b) {
  const Vector3 d = b - a;
  const double reach = radius_a + radius_b;
  return dot(d, d) <= reach * reach;
}

bool is_finite(const Vector3& v) { return std::isfinite(v.x + v.y + v.z); }

bool is_finite(const model::Pose& X) {
  const auto& q = X.rotation;
  return is_finite(X.translation) && std::isfinite(q.w + q.x + q.y + q.z);
}

/// Colliders of shapes; a mesh that several shapes have at one scale is made once.
class ColliderMaker {
 public:
  ColliderMaker(const FindSurface& find_surface,
                std::vector<std::unique_ptr<const Collider>>& colliders)
      : find_surface_(find_surface), colliders_(colliders) {}

  /// Null, with the reason, when there is none.
  const Collider* make(const Shape& shape, std::string& why) {
    if (shape.kind == "mesh") return surface(shape, why);
    if (auto made = primitive(shape)) return keep(std::move(*made));
    why = "a " + shape.kind + " is not supported, or has no size";
    return nullptr;
  }

 private:
  using MeshKey = std::pair<const mesh::TriangleMesh*, std::vector<double>>;

  const Collider* keep(Collider collider) {
    colliders_.push_back(std::make_unique<const Collider>(std::move(collider)));
    return colliders_.back().get();
  }

  const Collider* surface(const Shape& shape, std::string& why) {
    FoundSurface found = find_surface_(shape);
    why = found.why;
    if (!found.mesh || found.mesh->triangles.empty()) return nullptr;
    const Collider*& known = surfaces_[{found.mesh.get(), shape.numbers}];
    if (known) return known;
    const auto& scale = shape.numbers;
    triangles_ += found.mesh->triangles.size();
    if (triangles_ > kMaxCollisionTriangles) {
      why = shape.uri + ": the collisions have too many triangles in all";
      return nullptr;
    }
    known = keep(Collider::surface(
        *found.mesh, scale.size() >= 3 ? Vector3{scale[0], scale[1], scale[2]} : Vector3{1, 1, 1}));
    meshes_.push_back(std::move(found.mesh));
    return known;
  }

  const FindSurface& find_surface_;
  std::vector<std::unique_ptr<const Collider>>& colliders_;
  std::map<MeshKey, const Collider*> surfaces_;
  std::vector<std::shared_ptr<const mesh::TriangleMesh>> meshes_;  // a key's address stays its own
  std::size_t triangles_ = 0;
};

}  // namespace

CollisionBodies::CollisionBodies(const Robot& robot, const FindSurface& find_surface) {
  ColliderMaker maker(find_surface, colliders_);
  const std::vector<model::Pose> X_MB = body_poses(robot, {});
  for (std::uint32_t body = 0; body < robot.bodies.size(); ++body) {
    Group group{.first = parts_.size()};
    for (const robot::Part& part : robot.bodies[body].collisions) {
      if (!is_solid(part.shape)) continue;
      group.has_shape = true;
      std::string why;
      const Collider* collider = maker.make(part.shape, why);
      const bool placed = is_finite(compose(X_MB[body], part.X_BS));
      if (collider && (!placed || !std::isfinite(collider->ball_S().radius))) {
        why = "its pose or size is not finite";
        collider = nullptr;
      }
      if (!collider) {
        group.complete = false;
        unknown_.push_back({body, why});
        continue;
      }
      const Ball& ball_S = collider->ball_S();
      const Ball ball_B{transform(part.X_BS, ball_S.center), ball_S.radius};
      group.ball_B = group.count == 0 ? ball_B : joined_balls(group.ball_B, ball_B);
      ++group.count;
      parts_.push_back({body, part.X_BS, collider});
    }
    bodies_.push_back(group);
  }
}

CollisionPoses CollisionBodies::placed(const std::vector<model::Pose>& X_MB) const {
  CollisionPoses poses;
  poses.X_MS.reserve(parts_.size());
  for (const Part& part : parts_) poses.X_MS.push_back(compose(X_MB[part.body], part.X_BS));
  poses.center_M.reserve(bodies_.size());
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    poses.center_M.push_back(transform(X_MB[body], bodies_[body].ball_B.center));
  return poses;
}

bool CollisionBodies::collide(std::uint32_t a, std::uint32_t b, const CollisionPoses& poses) const {
  const Group& group_a = bodies_[a];
  const Group& group_b = bodies_[b];
  if (group_a.count == 0 || group_b.count == 0) return false;
  if (!balls_touch(poses.center_M[a], group_a.ball_B.radius, poses.center_M[b],
                   group_b.ball_B.radius))
    return false;
  for (std::size_t i = group_a.first; i < group_a.first + group_a.count; ++i) {
    const Ball& ball_i = parts_[i].collider->ball_S();
    const Vector3 center_i = transform(poses.X_MS[i], ball_i.center);
    for (std::size_t j = group_b.first; j < group_b.first + group_b.count; ++j) {
      const Ball& ball_j = parts_[j].collider->ball_S();
      if (!balls_touch(center_i, ball_i.radius, transform(poses.X_MS[j], ball_j.center),
                       ball_j.radius))
        continue;
      if (mesh::collide(*parts_[i].collider, poses.X_MS[i], *parts_[j].collider, poses.X_MS[j]))
        return true;
    }
  }
  return false;
}

}  // namespace rigor::robot
