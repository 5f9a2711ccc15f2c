// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What Bullet reads in a URDF and urdfdom rejects: both conversions from URDF take it as Bullet does, and say
// so. Private to the room.

#pragma once

#include <string>

#include <rigor/model/model.h>

namespace rigor::convert {

/// A ball joint by Bullet's name, which is no type of a `model::JointType`.
bool is_spherical(const model::Joint& joint);

/// Entries of the tensor that are not written, "ixy, iyz", and are 0 to Bullet.
std::string missing_entries(const model::Inertial& inertial);

/// Whether a link has a mass and a tensor, but not all entries of it.
bool has_incomplete_inertia(const model::Link& link);

}  // namespace rigor::convert
