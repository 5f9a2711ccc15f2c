// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a loaded model's structs do not hold, from its files: where URIs lead, colors, threads of screws.
//
//   Lookups lookups = lookups_in(loaded.root, workspace, resolver);
//   Robot robot = robot_of(loaded.root, frames, id, lookups);

#pragma once

#include <rigor/read/resolver.h>
#include <rigor/read/workspace.h>
#include <rigor/robot/robot.h>

namespace rigor::robot {

/// All but `find_mesh`. The arguments outlive the result.
///
/// A visual's color is the one that ambient and diffuse share; where they differ, what Gazebo's plain
/// light makes of them: 0.4 of the ambient and 0.8 of the diffuse one, at most 1. Its opacity is the
/// diffuse one's, less the transparency. Of a URDF it is what is written. Nothing where the file has
/// none in its own words (a material script, a texture).
Lookups lookups_in(const model::Root& root, read::Workspace& workspace,
                   const read::Resolver& resolver);

}  // namespace rigor::robot
