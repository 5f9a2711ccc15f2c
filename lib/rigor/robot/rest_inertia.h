// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How readily each axis of a robot at rest moves when all others are free: the diagonal of M⁻¹, M being the
// mass matrix of the joints at zero. MuJoCo calls it `dof_invweight0`.
//
//   const AxisValues inverse = inverse_inertias(robot, armature);
//   const double inertia = 1 / inverse[joint][axis];   // kg·m², or kg of a sliding axis
//
// With S the motion that an axis gives to what it carries, and I the inertia of all that, M has Sᵢᵀ Iⱼ Sⱼ where
// i carries j or is j, and zero where neither carries the other. It is factored along the tree (R. Featherstone,
// "Rigid Body Dynamics Algorithms", 2008, chapters 6 and 8). A root moves freely, but for the world. Joints that
// close a loop are left out.

#pragma once

#include <vector>

#include <rigor/robot/robot.h>

namespace rigor::robot {

/// By joint and axis.
using AxisValues = std::vector<std::vector<double>>;

/// 1/(kg·m²), or 1/kg of a sliding axis. `armature`, by joint, is inertia along each of its axes alone. Zero of an axis
/// that moves no mass, or hangs on one; and of all where the tree is far deeper than robots are.
AxisValues inverse_inertias(const Robot& robot, const std::vector<double>& armature);

}  // namespace rigor::robot
