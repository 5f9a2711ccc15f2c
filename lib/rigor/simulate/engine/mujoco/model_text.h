// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene as the text that MuJoCo compiles, all numbers with all of their digits, and where in MuJoCo's arrays each
// part of it is found then. Private to the folder.
//
//   const MujocoModelText made = mujoco_model_text(scene, settings);
//   load(made.xml);
//   qvel[made.axes[0].dof];
//
// MuJoCo numbers bodies, joints and geoms in the order of the text, each body's before those of its children
// (E. Todorov et al., "MuJoCo documentation", XML reference); the engine holds its counts against these.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// A degree of freedom of the scene: its position is start + sign · (qpos[position] - begin).
struct MujocoAxis {
  int position = -1;
  int dof = -1;
  double sign = 1;
  double start = 0;
  double begin = 0;
};

/// Where a loop is closed: two bodies of MuJoCo's, whose points `p_B` the joint holds together.
struct MujocoLoop {
  std::uint32_t joint = 0;
  int half = 0;
  int whole = 0;
  Vector3 p_B;
};

/// Indices are of the scene where they are not said to be MuJoCo's.
struct MujocoModelText {
  std::string xml;
  std::vector<MujocoAxis> axes;     ///< as in State::axes
  std::vector<int> bodies;          ///< body by body of the scene, MuJoCo's
  std::vector<int> halves;          ///< bodies of MuJoCo's that are halves of one
  std::vector<int> half_of;         ///< … of which of the scene's bodies
  std::vector<int> free_dofs;       ///< body by body, its first of six where it floats; else -1
  std::vector<int> free_positions;  ///< … of seven
  std::vector<int> body_of_dof;     ///< of the scene
  std::vector<MujocoLoop> loops;
  std::vector<std::uint32_t> shape_of_geom;
  std::vector<std::uint32_t> grids;  ///< shapes that are height grids, in MuJoCo's order
  int body_count = 1;                ///< with the world
  int joint_count = 0;
  int position_count = 0;
  int dof_count = 0;
};

/// An EngineError where MuJoCo cannot have such a scene.
MujocoModelText mujoco_model_text(const Scene& scene, const SolverSettings& settings);

}  // namespace rigor::simulate
