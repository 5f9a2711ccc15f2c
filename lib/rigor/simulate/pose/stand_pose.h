// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A pose in which a legged robot stands: a file says where its joints are, and few say where they should be. Zero
// is often a robot with its legs stretched out or folded up.
//
//   const StandPose pose = find_stand_pose(scene, wheels, group_states);
//   if (pose.found()) scene = in_stand_pose(scene, pose);
//
// Legs are pairs of limbs, alike and mirrored, that reach lower than what carries them. Poses that an author wrote go
// first (states of an SRDF); then the middle of the legs' limits; then a small search, both legs of a pair alike, for
// feet at one height and a center of mass well within them.

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <rigor/simulate/pose/group_state.h>
#include <rigor/simulate/scene/scene.h>
#include <rigor/simulate/wheels.h>

namespace rigor::simulate {

struct StandPose {
  enum class Need : std::uint8_t {
    kNone,      ///< it stands as it begins, or has no legs to stand on
    kFound,     ///< it stands so
    kNotFound,  ///< it has legs, and stands in none of the poses that were tried
  };
  Need need = Need::kNone;
  std::string from;               ///< "the middle of its joints' limits"
  std::vector<double> positions;  ///< of each joint of the scene, rad or m; its first axis

  bool found() const { return need == Need::kFound; }
};

/// For a model alone that nothing holds, on legs. `states`: named poses, the one to take first in front.
StandPose find_stand_pose(const Scene& scene, const DriveTrain& wheels,
                          const std::vector<GroupState>& states);

/// The scene in that pose, set down on the ground.
Scene in_stand_pose(const Scene& scene, const StandPose& pose);

/// "stands with its joints at the middle of their limits: hip 0.5 rad, knee -1 rad"; of many joints the first.
std::string in_words(const Scene& scene, const StandPose& pose);

}  // namespace rigor::simulate
