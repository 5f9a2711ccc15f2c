// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Something added that a simulator or a controller looks for, from a template that passes `validate`.
//
//   const Change change = with_sensor(*edited, SensorTemplate::kCamera, "head", {{0.1, 0, 0}, {}});
//   const Change control = with_ros2_control(*edited);
//
// Rates, sizes and ranges are those of common hardware, to be adapted. The robot stays the same.

#pragma once

#include <cstdint>
#include <string_view>

#include <rigor/author/verbs/change.h>
#include <rigor/model/pose.h>

namespace rigor::author {

enum class SensorTemplate : std::uint8_t { kCamera, kImu, kLidar };

/// In the link, with X_LS in m: in SDF its child, in URDF in a `<gazebo>` block that refers to it. Named after its kind,
/// with a number where that is taken.
Change with_sensor(const EditedModel& edited, SensorTemplate kind, std::string_view link,
                   const model::Pose& X_LS);

/// A `<ros2_control>` of mock hardware for all joints of a URDF that move: commands of position, or of velocity where a
/// joint is continuous; those that mimic another one have none.
Change with_ros2_control(const EditedModel& edited);

}  // namespace rigor::author
