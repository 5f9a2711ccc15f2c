// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Another frame for a link, while nothing moves in the world: what the link holds is written in the new frame.
//
//   const Change change = with_frame(*edited, "base_link", *frame_at(*edited, "base_link", FramePlace::kCenterOfMass));
//
// In URDF a link's frame is its joint's: it moves freely where that is fixed, and along the axis where it moves. In SDF
// joints stay where they are, and the mass that SDF defaults to is at the frame of its link.

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <rigor/author/verbs/change.h>
#include <rigor/model/pose.h>

namespace rigor::author {

enum class FramePlace : std::uint8_t {
  kCenterOfMass,  ///< the axes as they are
  kJoint,         ///< that carries the link
};

/// The pose of that place in the link's frame; nothing where there is none, as a center of mass without an
/// `<inertial>`, or no such link.
std::optional<model::Pose> frame_at(const EditedModel& edited, std::string_view link,
                                    FramePlace place);

/// X_LN is the pose of the new frame in the old one, m.
Change with_frame(const EditedModel& edited, std::string_view link, const model::Pose& X_LN);

}  // namespace rigor::author
