// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Something added that a simulator or a controller looks for, from a template (add_template.h) that passes every rule
// for its target.
//
//   AddRequest request;
//   request.what = "diff-drive";
//   const Change change = added(*edited, request);
//
// Rates, sizes and ranges are those of common hardware, to be adapted; what a drive must know of its wheels is measured
// (wheel_layout.h). The robot stays the same. Notes name the systems that a world of gz-sim has to load.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/verbs/change.h>
#include <rigor/model/pose.h>
#include <rigor/rules/target.h>

namespace rigor::author {

struct AddRequest {
  std::string what;  ///< one of addition_names()
  /// gz-sim when absent; of ros2_control and transmission ros.
  std::optional<rules::Target> target;
  /// The link of a sensor, the joint of a force_torque; of a joint-position-controller and a transmission the one joint,
  /// all that move when empty.
  std::string to;
  model::Pose X;  ///< of a sensor in that link or joint, m
  std::string
      parameters;  ///< path of the controllers' YAML, for what starts ros2_control in a simulator
};

/// Sensors: "camera", "depth_camera", "rgbd_camera", "imu", "lidar", "contact", "force_torque", "gps", "altimeter",
/// "magnetometer". Plugins: "diff-drive", "ackermann", "joint-state-publisher", "joint-position-controller",
/// "odometry-publisher", "pose-publisher". And "ros2_control" and "transmission", of URDF.
std::vector<std::string_view> addition_names();

/// What `to` has to name for the addition of that name: "LINK", "JOINT"; empty where it may be empty.
std::string_view needed_place(std::string_view name);

/// Refused: what its target has no template for, what the file's version of SDF has not, names that do not exist, and a
/// drive of a model without wheels. A name that is taken gets a number.
Change added(const EditedModel& edited, const AddRequest& request);

}  // namespace rigor::author
