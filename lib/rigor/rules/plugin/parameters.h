// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The parameters of well-known plugins that name a joint or a link of their model.

#pragma once

#include <string_view>

namespace rigor::rules {

enum class ParameterOf { kJoint, kLink };

struct PluginParameter {
  std::string_view library;  // without lib, .so, and the older name of Gazebo
  std::string_view element;
  ParameterOf what;
};

inline constexpr PluginParameter kPluginParameters[] = {
    {"gz-sim-ackermann-steering-system", "left_joint", ParameterOf::kJoint},
    {"gz-sim-ackermann-steering-system", "left_steering_joint", ParameterOf::kJoint},
    {"gz-sim-ackermann-steering-system", "right_joint", ParameterOf::kJoint},
    {"gz-sim-ackermann-steering-system", "right_steering_joint", ParameterOf::kJoint},
    {"gz-sim-apply-joint-force-system", "joint_name", ParameterOf::kJoint},
    {"gz-sim-detachable-joint-system", "parent_link", ParameterOf::kLink},
    {"gz-sim-diff-drive-system", "left_joint", ParameterOf::kJoint},
    {"gz-sim-diff-drive-system", "right_joint", ParameterOf::kJoint},
    {"gz-sim-hydrodynamics-system", "link_name", ParameterOf::kLink},
    {"gz-sim-joint-controller-system", "joint_name", ParameterOf::kJoint},
    {"gz-sim-joint-position-controller-system", "joint_name", ParameterOf::kJoint},
    {"gz-sim-joint-state-publisher-system", "joint_name", ParameterOf::kJoint},
    {"gz-sim-lift-drag-system", "link_name", ParameterOf::kLink},
    {"gz-sim-mecanum-drive-system", "back_left_joint", ParameterOf::kJoint},
    {"gz-sim-mecanum-drive-system", "back_right_joint", ParameterOf::kJoint},
    {"gz-sim-mecanum-drive-system", "front_left_joint", ParameterOf::kJoint},
    {"gz-sim-mecanum-drive-system", "front_right_joint", ParameterOf::kJoint},
    {"gz-sim-multicopter-motor-model-system", "jointName", ParameterOf::kJoint},
    {"gz-sim-multicopter-motor-model-system", "linkName", ParameterOf::kLink},
    {"gz-sim-thruster-system", "joint_name", ParameterOf::kJoint},
    {"gazebo_ros_diff_drive", "left_joint", ParameterOf::kJoint},
    {"gazebo_ros_diff_drive", "right_joint", ParameterOf::kJoint},
    {"gazebo_ros_joint_state_publisher", "joint_name", ParameterOf::kJoint},
    {"LiftDragPlugin", "link_name", ParameterOf::kLink},
};

}  // namespace rigor::rules
