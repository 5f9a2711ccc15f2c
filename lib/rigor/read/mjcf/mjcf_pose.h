// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Poses and orientations of MJCF: pos with quat, axisangle, xyaxes, zaxis or euler, and fromto.

#pragma once

#include <optional>

#include <rigor/model/pose.h>
#include <rigor/read/mjcf/mjcf_defaults.h>
#include <rigor/read/mjcf/mjcf_settings.h>

namespace rigor::read {

/// The least rotation that turns the z axis to a direction, which need not be a unit vector.
model::Quaternion rotation_to(const model::Vector3& z);

/// Angles in rad about axes named by the letters: lower case moves with the body, upper case is fixed.
model::Quaternion from_euler_sequence(std::string_view sequence,
                                      const std::array<double, 3>& angles);

model::Quaternion mjcf_orientation(const MjcfValues& values, const MjcfSettings& settings);
model::Pose mjcf_pose(const MjcfValues& values, const MjcfSettings& settings);

/// Where a shape with `fromto` is, its z axis along the segment, and half the segment's length.
struct Segment {
  model::Pose pose;
  double half_length = 0;  ///< m
};
std::optional<Segment> mjcf_segment(const MjcfValues& values);

}  // namespace rigor::read
