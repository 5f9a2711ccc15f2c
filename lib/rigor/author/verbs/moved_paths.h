// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Relative URIs of a model whose text is copied into a file of another folder.
//
//   append(edits, moved_paths(gripper, parent_path(arm.path())));
//   move_paths(expected, gripper, parent_path(arm.path()));
//
// Private to the room.

#pragma once

#include <string_view>
#include <vector>

#include <rigor/author/verbs/edited_model.h>
#include <rigor/robot/robot.h>
#include <rigor/text/edit.h>

namespace rigor::author {

/// In the model's own file: the URIs of meshes, heightmaps, images and includes, so that they lead to the same files
/// from `folder`. None where the model is in that folder.
std::vector<Edit> moved_paths(const EditedModel& of, std::string_view folder);

/// The law of it: the same for the shapes of the model's robot.
void move_paths(robot::Robot& robot, const EditedModel& of, std::string_view folder);

}  // namespace rigor::author
