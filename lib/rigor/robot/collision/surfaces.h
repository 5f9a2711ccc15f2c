// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The triangles of a robot's collisions, from its mesh files.
//
//   mass::MeshReads reads(disk, environment.workers);
//   const CollisionBodies bodies(robot, surface_finder(reads));

#pragma once

#include <rigor/mass/mesh/reads.h>
#include <rigor/robot/collision/collision_bodies.h>

namespace rigor::robot {

/// Of whole files. The reads outlive the result.
FindSurface surface_finder(mass::MeshReads& reads);

}  // namespace rigor::robot
