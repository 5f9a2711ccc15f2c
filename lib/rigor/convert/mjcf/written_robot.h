// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The robot that an MJCF text of `to_mjcf` describes, for its proof: bodies, joints, inertials, couplings
// and primitive shapes, read from the bytes as MuJoCo's documentation defines them. It reads what
// `to_mjcf` writes and no more.
//
//   std::optional<robot::Robot> robot = written_mjcf_robot(text);

#pragma once

#include <optional>
#include <string>

#include <rigor/robot/robot.h>

namespace rigor::convert {

/// rad or m: a limit from here on is none, and represents the one that a joint with only one limit lacks.
inline constexpr double kMjcfUnlimited = 1e10;

/// Joints that are no element are named by the body that they fix: "fixed:hand". A body with several
/// joints hangs on massless ones between them. An effort is infinite where no actuator limits it.
/// Nothing for a text that is no MJCF.
std::optional<robot::Robot> written_mjcf_robot(const std::string& text);

/// The name of a joint that MJCF has no element for.
std::string mjcf_fixed_name(const std::string& body);

}  // namespace rigor::convert
