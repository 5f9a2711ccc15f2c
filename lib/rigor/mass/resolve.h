// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a consumer will take a link's mass and inertia to be, which is not always what is written:
// what the file leaves out has a default, and formats differ in it.
//
//   Resolved link = resolve(root, frames, id, find_mesh);
//   total = add(total, transformed(X_ML, link.body));
//
// SDF (libsdformat 12): no <inertial> is 1 kg and the identity tensor; a mass without <inertia> keeps
// the identity. URDF (urdfdom): no <inertial>, or one that lacks its mass or an entry of its tensor,
// is no mass at all. The rotation of the inertial's pose turns the tensor into link axes. An automatic
// inertial (SDF 1.11; libsdformat 14) is what the collisions are as solids: a collision's density, else
// the link's, else 1000 kg/m³; scaled to the mass when one is written (libsdformat 15.2). MJCF: see geom_mass.h.

#pragma once

#include <rigor/mass/link_body.h>
#include <rigor/mass/mass_properties.h>
#include <rigor/model/model.h>

namespace rigor::mass {

/// Why a consumer takes the numbers it takes.
enum class Taken : std::uint8_t {
  kWritten,
  kDefaults,          ///< SDF, nothing is written: 1 kg and the identity
  kIdentity,          ///< SDF, a mass without a tensor
  kNothing,           ///< URDF, the inertial is missing or not whole: no mass
  kAutomatic,         ///< computed from the collisions
  kAutomaticUnknown,  ///< to be computed, but a collision is no solid: 1 kg and the identity
};

struct Resolved {
  MassProperties body;  ///< in the link frame
  Taken taken = Taken::kWritten;
};

Resolved resolve(const model::Root& root, const model::Frames& frames, model::Id<model::Link> link,
                 const FindMesh& find_mesh);

/// Without looking at shapes: of an automatic inertial, what is written or its defaults.
MassProperties resolve(const model::Root& root, model::Id<model::Link> link);

/// The tensor's numbers as they stand in the file or default, along the inertial's own axes.
Inertia tensor(const model::Inertial& inertial);

/// Whether the numbers are to be computed from the collisions when the model is loaded (SDF 1.11,
/// auto="true"): what `resolve` gives is only a placeholder then.
inline bool is_automatic(const model::Link& link) { return link.inertial.automatic.value; }

}  // namespace rigor::mass
