// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the joints of a robot stand as a run begins.

#pragma once

#include <vector>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::simulate {

struct Start {
  model::JointPositions positions;
  std::vector<model::Id<model::Joint>> moved;  ///< those that nobody placed, at a limit
};

/// A URDF says nothing of where its joints stand. They begin at zero, or where zero is outside their
/// limits at the nearer one, and those that mimic them where that puts them; `positions` go before. The joints
/// of an SDF model stand where its links are.
Start start_within_limits(const model::Root& root, model::JointPositions positions);

}  // namespace rigor::simulate
