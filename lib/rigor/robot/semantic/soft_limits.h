// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The bounds that MoveIt gives a joint: its limits, or the soft limits of URDF's `<safety_controller>` where those
// are narrower (moveit_core, RobotModel::constructJointModel).
//
//   const Robot robot = within_soft_limits(robot_of(loaded.root, frames, id), loaded.root);

#pragma once

#include <rigor/model/model.h>
#include <rigor/robot/robot.h>

namespace rigor::robot {

struct PositionRange {
  double lower = 0, upper = 0;  ///< rad or m
};

/// The range, or what of it is within the joint's soft limits. Soft limits that are not written, are inverted, or
/// leave nothing change nothing.
PositionRange within_soft_limits(const PositionRange& range, const model::Joint& joint);

/// The same of all joints of the root by their names. A robot from SDF has no soft limits and stays as it is.
Robot within_soft_limits(Robot robot, const model::Root& root);

}  // namespace rigor::robot
