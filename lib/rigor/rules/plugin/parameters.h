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
    {"gz-sim-buoyancy-engine-system", "link_name", ParameterOf::kLink},
    {"gz-sim-detachable-joint-system", "parent_link", ParameterOf::kLink},
    {"gz-sim-diff-drive-system", "left_joint", ParameterOf::kJoint},
    {"gz-sim-diff-drive-system", "right_joint", ParameterOf::kJoint},
    {"gz-sim-hydrodynamics-system", "link_name", ParameterOf::kLink},
    {"gz-sim-joint-controller-system", "joint_name", ParameterOf::kJoint},
    {"gz-sim-joint-position-controller-system", "joint_name", ParameterOf::kJoint},
    {"gz-sim-joint-state-publisher-system", "joint_name", ParameterOf::kJoint},
    {"gz-sim-joint-trajectory-controller-system", "joint_name", ParameterOf::kJoint},
    {"gz-sim-kinetic-energy-monitor-system", "link_name", ParameterOf::kLink},
    {"gz-sim-lift-drag-system", "control_joint_name", ParameterOf::kJoint},
    {"gz-sim-lift-drag-system", "link_name", ParameterOf::kLink},
    {"gz-sim-lighter_than_air_dynamics-system", "link_name", ParameterOf::kLink},
    {"gz-sim-mecanum-drive-system", "back_left_joint", ParameterOf::kJoint},
    {"gz-sim-mecanum-drive-system", "back_right_joint", ParameterOf::kJoint},
    {"gz-sim-mecanum-drive-system", "front_left_joint", ParameterOf::kJoint},
    {"gz-sim-mecanum-drive-system", "front_right_joint", ParameterOf::kJoint},
    {"gz-sim-multicopter-control-system", "comLinkName", ParameterOf::kLink},
    {"gz-sim-multicopter-motor-model-system", "jointName", ParameterOf::kJoint},
    {"gz-sim-multicopter-motor-model-system", "linkName", ParameterOf::kLink},
    {"gz-sim-thruster-system", "joint_name", ParameterOf::kJoint},
    {"gz-sim-track-controller-system", "link", ParameterOf::kLink},
    {"gz-sim-trajectory-follower-system", "link_name", ParameterOf::kLink},
    {"gz-sim-velocity-control-system", "link_name", ParameterOf::kLink},
    {"gazebo_ros_ackermann_drive", "front_left_joint", ParameterOf::kJoint},
    {"gazebo_ros_ackermann_drive", "front_right_joint", ParameterOf::kJoint},
    {"gazebo_ros_ackermann_drive", "left_steering_joint", ParameterOf::kJoint},
    {"gazebo_ros_ackermann_drive", "rear_left_joint", ParameterOf::kJoint},
    {"gazebo_ros_ackermann_drive", "rear_right_joint", ParameterOf::kJoint},
    {"gazebo_ros_ackermann_drive", "right_steering_joint", ParameterOf::kJoint},
    {"gazebo_ros_ackermann_drive", "steering_wheel_joint", ParameterOf::kJoint},
    {"gazebo_ros_diff_drive", "leftJoint", ParameterOf::kJoint},
    {"gazebo_ros_diff_drive", "left_joint", ParameterOf::kJoint},
    {"gazebo_ros_diff_drive", "rightJoint", ParameterOf::kJoint},
    {"gazebo_ros_diff_drive", "right_joint", ParameterOf::kJoint},
    {"gazebo_ros_f3d", "bodyName", ParameterOf::kLink},
    {"gazebo_ros_f3d", "body_name", ParameterOf::kLink},
    {"gazebo_ros_force", "bodyName", ParameterOf::kLink},
    {"gazebo_ros_force", "link_name", ParameterOf::kLink},
    {"gazebo_ros_ft_sensor", "jointName", ParameterOf::kJoint},
    {"gazebo_ros_ft_sensor", "joint_name", ParameterOf::kJoint},
    {"gazebo_ros_imu", "bodyName", ParameterOf::kLink},
    {"gazebo_ros_joint_state_publisher", "joint_name", ParameterOf::kJoint},
    {"gazebo_ros_p3d", "bodyName", ParameterOf::kLink},
    {"gazebo_ros_p3d", "body_name", ParameterOf::kLink},
    {"gazebo_ros_skid_steer_drive", "leftFrontJoint", ParameterOf::kJoint},
    {"gazebo_ros_skid_steer_drive", "leftRearJoint", ParameterOf::kJoint},
    {"gazebo_ros_skid_steer_drive", "rightFrontJoint", ParameterOf::kJoint},
    {"gazebo_ros_skid_steer_drive", "rightRearJoint", ParameterOf::kJoint},
    {"gazebo_ros_tricycle_drive", "actuatedWheelJoint", ParameterOf::kJoint},
    {"gazebo_ros_tricycle_drive", "encoderWheelLeftJoint", ParameterOf::kJoint},
    {"gazebo_ros_tricycle_drive", "encoderWheelRightJoint", ParameterOf::kJoint},
    {"gazebo_ros_tricycle_drive", "steeringJoint", ParameterOf::kJoint},
    {"gazebo_ros_vacuum_gripper", "bodyName", ParameterOf::kLink},
    {"gazebo_ros_vacuum_gripper", "link_name", ParameterOf::kLink},
    {"LiftDragPlugin", "link_name", ParameterOf::kLink},
};

}  // namespace rigor::rules
