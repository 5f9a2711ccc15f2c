// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A part of a robot taken out of its file: removed, or left alone as a model of its own.
//
//   const Change change = removed(*edited, "camera_link", Subtree::kRefused, {"robot.srdf"});
//   const Change hand = extracted(*edited, "palm", {});
//
// What names a removed link or joint goes with it: `<gazebo reference>`, transmissions, joints of ros2_control, SDF's
// frames and grippers, the pairs, groups and states of SRDF. A pose relative to something removed is written in the
// model's frame. Plugins and files of parameters stay, and are listed. A joint that mimics a removed one refuses it.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/names/workspace_files.h>
#include <rigor/author/verbs/change.h>

namespace rigor::author {

/// What becomes of a link that carries others.
enum class Subtree : std::uint8_t { kRefused, kRemoved };

Change removed(const EditedModel& edited, std::string_view link, Subtree subtree,
               const ReferringFiles& files);

/// All but the link and what it carries is removed; it is the root of what is left, its frame in the model (SDF) as it
/// was.
Change extracted(const EditedModel& edited, std::string_view link, const ReferringFiles& files);

}  // namespace rigor::author
