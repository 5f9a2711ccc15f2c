// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Joints of bodies: limits, springs and what drives them.

#pragma once

#include <map>
#include <string>

#include <rigor/model/model.h>
#include <rigor/read/mjcf/mjcf_scope.h>

namespace rigor::read {

/// Without its ends. The pose is in the frame of the body.
model::Joint mjcf_joint(const MjcfValues& values, const MjcfPlace& place);

/// Joints by their names, prefixes included; of two with one name the first.
using MjcfJoints = std::map<std::string, model::Id<model::Joint>, std::less<>>;

/// What equalities say of joints that follow others, and actuators of efforts.
void read_mjcf_couplings(const MjcfScope& scope, const MjcfJoints& joints, model::Root& root);

}  // namespace rigor::read
