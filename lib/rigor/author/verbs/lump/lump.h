// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Links on fixed joints made one with the links that carry them, as simulators do when they load a URDF.
//
//   const Change change = lumped(*edited, {});            // all of them
//   const Change one = lumped(*edited, {"camera_link"});
//
// What a link holds moves to the link that carries it, with the bytes that it had but for its pose; masses and tensors are
// summed. Joints that hung on it hang on that one. In SDF from 1.7 on a frame of the link's name stays where the link was, so
// whatever refers to it means the same; in URDF the reference of a `<gazebo>` block is changed. Other files are left as they
// are, and before 1.7 what plugins name is listed.

#pragma once

#include <string>
#include <vector>

#include <rigor/author/verbs/change.h>

namespace rigor::author {

/// Those links; with none, every link on a fixed joint. Refused: SDF 1.0, poses in frames of 1.5 and 1.6, and parts in
/// files that are included.
Change lumped(const EditedModel& edited, const std::vector<std::string>& links);

}  // namespace rigor::author
