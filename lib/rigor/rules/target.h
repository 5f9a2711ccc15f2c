// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The consumers that a model is meant for. A rule that is about some of them only runs when one is asked
// for: `--target gz-sim`.
//
//   Rule rule() { return {…, .targets = {Target::kGazeboClassic, Target::kGzSim}, …}; }

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rigor::rules {

enum class Target : std::uint8_t { kGazeboClassic, kGzSim, kRos, kMujoco, kIsaac, kBullet };

using Targets = std::vector<Target>;

/// "gazebo-classic", "gz-sim", "ros", "mujoco", "isaac", "bullet"
std::string_view to_string(Target target);

/// Nothing when no target has that name.
std::optional<Target> target_named(std::string_view name);

/// All names, in the order of the enumeration.
std::vector<std::string_view> target_names();

}  // namespace rigor::rules
