// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a consumer will take a link's mass and inertia to be, which is not always what is written:
// what the file leaves out has a default, and formats differ in it.
//
//   MassProperties body = resolve(root, link_id);
//   total += body.mass;
//
// SDF (libsdformat 12): no <inertial> is 1 kg and the identity tensor; a mass without <inertia> keeps
// the identity. URDF (urdfdom): no <inertial>, or one that lacks its mass or an entry of its tensor,
// is no mass at all. The rotation of the inertial's pose turns the tensor into link axes.

#pragma once

#include <rigor/mass/mass_properties.h>
#include <rigor/model/model.h>

namespace rigor::mass {

/// In the link frame. Of an automatic inertial, what is written or its defaults.
MassProperties resolve(const model::Root& root, model::Id<model::Link> link);

/// The tensor's numbers as they stand in the file or default, along the inertial's own axes.
Inertia tensor(const model::Inertial& inertial);

/// Whether the numbers are to be computed from the collisions when the model is loaded (SDF 1.11,
/// auto="true"): what `resolve` gives is only a placeholder then.
inline bool is_automatic(const model::Link& link) { return link.inertial.automatic.value; }

}  // namespace rigor::mass
