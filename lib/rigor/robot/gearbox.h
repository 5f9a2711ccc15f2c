// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SDF's gearboxes as what they are: one joint that follows another.
//
//   for (const GearCoupling& gear : gear_couplings(root, frames)) …

#pragma once

#include <vector>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::robot {

/// The follower's angle is `multiplier` times the leader's.
struct GearCoupling {
  model::Id<model::Joint> gearbox;
  model::Id<model::Joint> leader;
  model::Id<model::Joint> follower;
  double multiplier = 1;
};

/// A gearbox says of the angles from a reference body R to its parent P (about its first axis) and to its child C
/// (about its second): θ_RC = -ratio · θ_RP (SDF's element `gearbox_reference_body`). Where one revolute joint is
/// between R and P and another between R and C, each along the gearbox's axis, the second follows the first. Not in
/// the result are gearboxes of which that is not so, whose ratio is zero, and whose follower follows another joint or
/// would follow itself.
std::vector<GearCoupling> gear_couplings(const model::Root& root, const model::Frames& frames);

}  // namespace rigor::robot
