// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where everything is at one moment of a run: what the engine tells after each step, and what metrics
// look at. Indices are those of the scene; everything is in W.

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

struct BodyState {
  Vector3 p_WBcm;   ///< of the center of mass, m
  Quaternion R_WB;  ///< of the body's frame
  Vector3 v_WBcm;   ///< m/s
  Vector3 w_WB;     ///< rad/s
};

struct AxisState {
  double position = 0;  ///< rad (counted over full turns) or m
  double velocity = 0;
  double effort = 0;  ///< N·m or N: what commands put in during the last step
};

/// One point where two shapes touch.
struct ContactState {
  std::uint32_t shape_a = 0;
  std::uint32_t shape_b = 0;
  Vector3 point;
  Vector3 normal;    ///< unit vector, out of b into a
  double depth = 0;  ///< m
  Vector3 force;     ///< N, on a; zero unless forces are asked for
};

struct State {
  double time = 0;  ///< s
  std::vector<BodyState> bodies;
  std::vector<AxisState> axes;  ///< joint by joint; `first_axis` says where a joint's begin
  std::vector<ContactState> contacts;
  double anchor_error = 0;              ///< m: the largest gap of a joint's two anchors
  std::uint32_t anchor_joint = kWorld;  ///< whose
  double motor_work = 0;                ///< J that commands put in so far
};

/// X_WB of a body.
Pose pose_of(const SceneBody& body, const BodyState& state);

}  // namespace rigor::simulate
