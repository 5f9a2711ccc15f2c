// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What in its file goes on naming a link that became part of another, or the joint between them: plugins, frames of
// sensors, transmissions. Poses and ends of joints are not among it, which `lump` rewrites or which mean the frame of that
// name.
//
//   for (std::string& line : names_left(edited, held_by, joints)) change.notes.push_back(std::move(line));
//
// Private to the room.

#pragma once

#include <set>
#include <string>
#include <vector>

#include <rigor/author/verbs/edited_model.h>
#include <rigor/author/verbs/lump/link_settings.h>

namespace rigor::author {

/// A line each: "arm.sdf:12: a plugin names link hand, which is part of arm now".
std::vector<std::string> names_left(const EditedModel& edited, const HeldBy& held_by,
                                    const std::set<std::string>& joints);

}  // namespace rigor::author
