// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A prefix for all names of a model: its links, joints and frames, and the models nested in it, wherever files refer to
// them. So two of one robot can be in one model, or in one tf2 tree.
//
//   const Change change = prefixed(*edited, "left_", {"robot.urdf", "robot.srdf", "controllers.yaml"});
//
// The model keeps its own name, and a link `world` its meaning. Names of collisions, visuals, materials and sensors are
// as they were: they are unique in what holds them, or shared on purpose.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/names/workspace_files.h>
#include <rigor/author/verbs/change.h>

namespace rigor::author {

/// `files` are models, SRDF and files of parameters in which references are renamed, too.
Change prefixed(const EditedModel& edited, std::string_view prefix, const ReferringFiles& files);

/// The prefix taken away from the names that have it.
Change unprefixed(const EditedModel& edited, std::string_view prefix, const ReferringFiles& files);

}  // namespace rigor::author
