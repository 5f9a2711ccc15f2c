// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Another link as the root of a robot: the joints between it and the old root change parent and child.
//
//   const Change change = rerooted(*edited, "gripper_base");
//
// Each joint that is turned has its axis negated and keeps its frame, so its position, limits and mimics mean what they
// meant. In URDF a link's frame is that of the joint that carries it: links on the way get another frame, and what they
// hold is written in that. In SDF links stay where they are.

#pragma once

#include <string_view>

#include <rigor/author/verbs/change.h>

namespace rigor::author {

/// Refused: a robot that is fixed to the world or has closed loops, and joints of several axes on the way. The notes
/// list the joints that are turned.
Change rerooted(const EditedModel& edited, std::string_view link);

}  // namespace rigor::author
