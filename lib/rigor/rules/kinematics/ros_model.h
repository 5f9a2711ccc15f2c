// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which models in SDF may be given to ROS as the description of a robot.

#pragma once

#include <rigor/model/id.h>
#include <rigor/model/model.h>

namespace rigor::rules {

/// A model by itself, with joints, that moves. What stands in a world is for simulators.
inline bool may_be_for_ros(const model::Root& root, model::Id<model::Model> id) {
  if (!id || !root.worlds.empty()) return false;
  const model::Model& model = root[id];
  return !model.parent && !model.joints.empty() && !model.is_static.value;
}

}  // namespace rigor::rules
