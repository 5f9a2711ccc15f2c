// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What hangs on joints: the bodies, their inertia, and what gravity and a motion ask of a motor. For
// sources of this room.
//
//   const JointLoads loads(scene);
//   if (loads.weight(joint) > joint.axes[0].effort) add_cause();

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/mass/mass_properties.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// Of each body what joints hang on it, found once for a scene.
class CarriedBodies {
 public:
  /// The scene outlives it.
  explicit CarriedBodies(const Scene& scene);

  /// The joints between two bodies whose parent this one is.
  const std::vector<std::uint32_t>& joints_on(std::uint32_t body) const { return joints_[body]; }

  /// The body and all that joints hang on it.
  std::vector<std::uint32_t> by(std::uint32_t body) const;

 private:
  const Scene& scene_;
  std::vector<std::vector<std::uint32_t>> joints_;  // by their parent
};

/// Whether a motor can move it by itself: a hinge or a slider that follows no other joint.
bool can_be_commanded(const SceneJoint& joint);

/// kg·m² (of a slider kg): what an effort between the joint's two bodies moves when everything else
/// gives way: the two inertias in series.
double effective_inertia(const Scene& scene, const SceneJoint& joint);

/// How a sweep moves a joint.
struct SweepMotion {
  double least = 0;  ///< rad, m
  double most = 0;
  double speed = 0;         ///< rad/s, m/s
  double acceleration = 0;  ///< rad/s², m/s², as it starts and stops
};

/// Of joints of the scene that can be commanded, and whose child is a body.
class JointLoads {
 public:
  /// The scene outlives it.
  explicit JointLoads(const Scene& scene);

  /// kg·m², of all that hangs on a hinge (of a slider: kg), about its axis.
  double inertia(const SceneJoint& joint) const;

  /// N·m (of a slider N): what gravity asks of the joint at the start.
  double weight(const SceneJoint& joint) const;

  /// N·m (of a slider N): what the joint has to hold at the start: the weight of its subtree, and of a
  /// model that stands by itself what the ground pushes up with where that touches it, each body that does
  /// with the same share of the model's weight. So the knee of a leg bears the robot.
  double standing(const SceneJoint& joint) const;

  /// kg·m² (of a slider kg): of all that hangs on the joint, and of what stands on it: each body that touches
  /// the ground carries its share of the mass, as far from the axis as the ground is.
  double standing_inertia(const SceneJoint& joint) const;

  /// N·m (of a slider N): the most that a motor has to give for it, with all else held as at the start:
  /// against gravity, to start and stop, against friction and damping.
  double sweep_effort(const SceneJoint& joint, const SweepMotion& motion) const;

  /// N·m (of a slider N): with which gravity moves the joint on, where it is `moved` (rad, m) from the start and all
  /// else is as there.
  double gravity_effort(const SceneJoint& joint, double moved) const;

 private:
  void find_feet();

  const Scene& scene_;
  CarriedBodies carried_;
  std::vector<mass::MassProperties> in_W_;  // of each body, at the start

  struct Foot {
    bool stands = false;  // it touches the ground, of a model that nothing else holds
    Vector3 middle_W;     // of what touches
    Vector3 force_W;      // N, what the ground pushes with
  };
  std::vector<Foot> feet_;  // of each body
};

}  // namespace rigor::simulate
