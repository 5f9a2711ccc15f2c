// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Relative URIs of a model whose text goes into a file of another folder.
//
//   append(edits, moved_paths(gripper.document(), gripper.path(), parent_path(arm.path())));
//   move_paths(expected, gripper, parent_path(arm.path()));
//   std::string text = moved_text(changed, "arm.urdf", "build/left_arm.urdf");

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/verbs/edited_model.h>
#include <rigor/robot/robot.h>
#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::author {

/// In the document of the file `path`: the URIs of meshes, heightmaps, images, textures, materials and includes, so
/// that they lead to the same files from `folder`. None where the file is in that folder.
std::vector<Edit> moved_paths(const xml::Document& document, std::string_view path,
                              std::string_view folder);

/// The law of it: the same for the shapes of the model's robot.
void move_paths(robot::Robot& robot, const EditedModel& of, std::string_view folder);

/// The text of the file `path` as it is written to `out`: as it is where both are in one folder.
std::string moved_text(const std::string& text, std::string_view path, std::string_view out);

}  // namespace rigor::author
