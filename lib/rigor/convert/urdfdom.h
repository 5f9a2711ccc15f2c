// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What urdfdom, which ROS reads its robots with, makes of a URDF: an outside judge. It shares no line of
// code with rigor's reader, so a conversion that compares equal to what it read is proven by somebody
// else's eyes.
//
//   UrdfdomVerdict verdict = judge_by_urdfdom(urdf_text(robot), environment.workers);
//   if (verdict.robot) differences = compare(source, *verdict.robot, names);
//   else say(verdict.messages);
//
// urdfdom prints as it likes and never returns from some files (links in a loop), so it runs in a worker
// process.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/process/request.h>
#include <rigor/process/serve.h>
#include <rigor/process/workers.h>
#include <rigor/robot/robot.h>

namespace rigor::convert {

/// urdfdom takes under 10 ms for any of 452 real robots; a second means that it goes in circles.
inline constexpr process::RequestLimits kUrdfdomLimits{.cpu_seconds = 2};

struct UrdfdomVerdict {
  /// Nothing when it refused the file, or did not come back.
  std::optional<robot::Robot> robot;
  /// What it said: errors and warnings in their order; how it ended when it did not come back. It
  /// reads some files with errors, and leaves out what they refer to.
  std::vector<std::string> messages;
  bool died = false;  ///< crashed, or ran out of time or memory
  bool asked = true;  ///< false in a build without urdfdom
};

/// Links and joints come sorted by name, as urdfdom keeps them; nothing has a span. A mesh's `path` is
/// empty, and there are no frames.
UrdfdomVerdict judge_by_urdfdom(std::string_view urdf, const process::Workers& workers);

/// What a worker has to serve for this.
process::Service urdfdom_service();

}  // namespace rigor::convert
