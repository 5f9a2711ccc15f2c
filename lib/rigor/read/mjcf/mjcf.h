// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads MJCF, MuJoCo's XML format, into a `Root` with one model.
//
// A body is a link, whose pose is relative to the body around it. A joint is where the file has it; a body without
// one has a fixed joint. Between two joints of one body is a link without mass (`Link::between_joints`). What
// hangs on the world has a joint to `world`; shapes of the world itself are those of a link of that name. A free
// joint is a floating one. A geom is a collision if it may touch anything, a visual if MuJoCo's viewer draws it, or
// both; only one of them has its weight. A site is a frame. Classes, frames, copies, units, angles and sequences are
// resolved: what the model holds is in meters and radians.

#pragma once

#include <rigor/model/model.h>
#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/read/mjcf/mjcf_includes.h>
#include <rigor/read/workspace.h>

namespace rigor::read {

/// `file` has a document whose root is `<mujoco>`.
MjcfIncludes read_mjcf(model::Root& root, Workspace& workspace, const File& file, MjcfFacts& facts);

}  // namespace rigor::read
