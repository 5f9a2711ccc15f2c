// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The collision shapes of a robot's bodies, ready to be held against each other at any pose.
//
//   const CollisionBodies bodies(robot, find_surface);
//   const CollisionPoses poses = bodies.placed(body_poses(robot, positions));
//   if (bodies.collide(a, b, poses)) …

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <rigor/mesh/collide/collider.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/robot/robot.h>

namespace rigor::robot {

/// The triangles of a shape whose kind is `mesh`, not scaled; null, with the reason in words, when there are none:
/// "meshes/arm.dae is not found".
struct FoundSurface {
  std::shared_ptr<const mesh::TriangleMesh> mesh = nullptr;
  std::string why = {};
};
using FindSurface = std::function<FoundSurface(const Shape&)>;

/// A collision that cannot be held against others.
struct UnknownShape {
  std::uint32_t body = 0;
  std::string why;
};

/// Triangles of all meshes of a robot, each counted once: FCL's tree takes half a kilobyte for each. More are unknown.
inline constexpr std::size_t kMaxCollisionTriangles = 2'000'000;

/// Where all shapes are, in the frame of the model.
struct CollisionPoses {
  std::vector<model::Pose> X_MS;         ///< by shape
  std::vector<model::Vector3> center_M;  ///< of the ball around a body's shapes, by body
};

class CollisionBodies {
 public:
  CollisionBodies(const Robot& robot, const FindSurface& find_surface);

  /// Whether the body has a collision with a surface, known or not.
  bool has_shape(std::uint32_t body) const { return bodies_[body].has_shape; }
  /// Whether all of them are known.
  bool is_complete(std::uint32_t body) const { return bodies_[body].complete; }
  const std::vector<UnknownShape>& unknown() const { return unknown_; }

  CollisionPoses placed(const std::vector<model::Pose>& X_MB) const;

  /// Whether a known shape of one touches one of the other. Safe across threads.
  bool collide(std::uint32_t a, std::uint32_t b, const CollisionPoses& poses) const;

 private:
  struct Part {
    std::uint32_t body;
    model::Pose X_BS;
    const mesh::Collider* collider;
  };
  struct Group {
    std::size_t first = 0, count = 0;  ///< in parts_
    mesh::Ball ball_B;
    bool has_shape = false;
    bool complete = true;
  };

  std::vector<std::unique_ptr<const mesh::Collider>> colliders_;
  std::vector<Part> parts_;    // by body
  std::vector<Group> bodies_;  // as the robot's
  std::vector<UnknownShape> unknown_;
};

}  // namespace rigor::robot
