// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the numbers of a joint mean, whatever the format and version they were written in. This is the
// one place that knows what "no limit" is:
//
//   | format        | effort, velocity              | lower, upper     |
//   |---------------|-------------------------------|------------------|
//   | any           | not written, inf, from 1e16   | inf, from 1e16   |
//   | any           | negative: -1 up to SDF 1.9    |                  |
//   | SDF up to 1.3 | 0, which is the default there |                  |
//
//   if (effort_limit(root, joint, axis) == 0) tell_that_nothing_can_drive_it();

#pragma once

#include <rigor/model/model.h>

namespace rigor::model {

/// A limit of this size or more is none: SDF's own word for infinity before 1.10.
inline constexpr double kUnlimited = 1e16;

/// A lower or upper limit without its sentinel, rad or m: infinite (negative for a lower one) from
/// 1e16 on.
double position_limit(double value);

/// The same of an effort or a velocity, where a negative number, nan, or none at all, says that there is
/// no limit.
double magnitude_limit(double value);

/// N·m, or N of a prismatic joint; infinite when there is no limit, 0 when nothing can drive the joint.
double effort_limit(const Root& root, const Joint& joint, const Axis& axis);

/// rad/s, or m/s of a prismatic joint; infinite when there is no limit, 0 when it cannot move.
double velocity_limit(const Root& root, const Joint& joint, const Axis& axis);

/// How far a screw moves along its axis while it turns by a radian, m/rad; positive for a right-handed
/// thread. From SDF 1.10 `<screw_thread_pitch>` is meters for each turn, 1 by default; `<thread_pitch>`
/// is radians for each meter of a left-handed thread, as Gazebo classic reads it.
double screw_lead(const Root& root, const Joint& joint);

}  // namespace rigor::model
