// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What MuJoCo makes of an MJCF body: what `<inertial>` says, else the sum of its geoms, each of its mass or of its
// density; then what `<compiler>` asks of all bodies (balanceinertia, boundmass, boundinertia, settotalmass).
//
//   if (auto body = geom_mass(root, link, find_mesh)) use(*body);
//
// Shells (`shellinertia`) of spheres, boxes, capsules and cylinders are closed forms of thin sheets; others count as
// solids. Of a mesh that does not enclose a volume, its hull counts. A primitive that is fitted to a mesh counts as that
// (fitted_primitive.h), but where the file asks for one fitted to the bounds, which counts as the mesh.

#pragma once

#include <optional>

#include <rigor/mass/find_mesh.h>
#include <rigor/mass/mass_properties.h>
#include <rigor/model/model.h>

namespace rigor::mass {

/// In the link frame; nothing when a mesh that counts is not found or has no volume.
std::optional<MassProperties> geom_mass(const model::Root& root, model::Id<model::Link> link,
                                        const FindMesh& find_mesh);

}  // namespace rigor::mass
