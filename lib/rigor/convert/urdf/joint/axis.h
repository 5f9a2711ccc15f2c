// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An SDF axis as URDF says it: direction, limits, damping and friction. Private to the room.
//
// SDF says "no limit" in several ways: -1, infinity, 1e16, nothing, and up to 1.3 an effort of zero.
// URDF has none, and needs an effort and a velocity wherever it needs limits; what represents infinity
// is then in the account.

#pragma once

#include <cstddef>

#include <rigor/convert/urdf/draft.h>
#include <rigor/convert/urdf/robot.h>
#include <rigor/model/model.h>

namespace rigor::convert {

/// Gives `target` the joint's k-th axis. Its type is set already: revolute, continuous or prismatic; a
/// revolute one without limits becomes continuous.
void set_axis(UrdfDraft& draft, model::Id<model::Joint> joint, std::size_t k, UrdfJoint& target);

/// The limits of a joint that has none, for a type that must have them.
UrdfLimit no_limit(const UrdfOptions& options);

}  // namespace rigor::convert
