// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The pose of a collision or visual moved in a user's file, in the form its author chose: SDF's
// `<pose>` in radians, degrees or as a quaternion, relative to whatever it is, SDF 1.0's
// `<origin pose>`, or URDF's `<origin xyz rpy>`.
//
//   auto edits = write_pose(document, element, pose_form(model), visual.pose.pose.value,
//                           {.offset = {0, 0, 0.1}});
//
// A number that does not change keeps its bytes, so writing twice is writing once.

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::write {

enum class PoseForm : std::uint8_t {
  kPose,       ///< `<pose>x y z roll pitch yaw</pose>`
  kOldOrigin,  ///< SDF 1.0: `<origin pose="x y z roll pitch yaw"/>`
  kUrdf,       ///< `<origin xyz="x y z" rpy="roll pitch yaw"/>`
};

PoseForm pose_form(const model::Model& model);

/// A quarter turn about x is all that a change of a mesh's up axis takes. It leaves pitch and yaw
/// alone: R·Rx(a) has the angles (roll + a, pitch, yaw).
enum class Turn : std::uint8_t { kNone, kBackAboutX };

/// X becomes X · turn · translation(offset), so that it does not matter what X is relative to.
struct PoseChange {
  Turn turn = Turn::kNone;  ///< by -90°
  model::Vector3 offset;    ///< m, in the turned frame
};

/// `X` is the pose of `part`, a collision or visual, as it was read from there. One that is not
/// written is added in front of the geometry unless it is the identity. Nothing when what stands
/// there is no pose, and in a document that was cut.
std::optional<std::vector<Edit>> write_pose(const xml::Document& document, xml::Element part,
                                            PoseForm form, const model::Pose& X,
                                            const PoseChange& change);

}  // namespace rigor::write
