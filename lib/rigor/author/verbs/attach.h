// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A robot put on a link of another one: a gripper on an arm.
//
//   AttachRequest request;
//   request.link = "tool0";
//   request.X_LG = {{0, 0, 0.05}, {}};
//   const Change change = attached(reader, *arm, *gripper, request);
//
// In URDF the gripper's elements are copied behind the arm's, in SDF its model is nested in the arm's, each with its
// comments and layout. G is the gripper's model frame, which in URDF is its root link's. Where a name of the gripper is
// taken in the arm, all names of the gripper get a prefix, those of its hardware too; materials of one name that look alike
// become one. Paths of meshes that are relative lead on to the same files.
//
// With AttachBy::kInclude an SDF model is included, and stays in its own file. A template as the arm always includes the
// gripper's; where that one only defines a macro, attach_macro.h calls it.

#pragma once

#include <cstdint>
#include <string>

#include <rigor/author/verbs/change.h>
#include <rigor/model/pose.h>

namespace rigor::author {

enum class AttachJoint : std::uint8_t {
  kFixed,
  kRevolute,  ///< about the z axis of G
};

enum class AttachBy : std::uint8_t { kCopy, kInclude };

struct AttachRequest {
  std::string link;  ///< of the arm; empty: the one that `frame` is on
  model::Pose X_LG;  ///< of the gripper in the link, m
  /// A frame or link of the arm that the pose is relative to rather than to `link`.
  std::string frame;
  /// A frame or link of the gripper that is put there rather than G.
  std::string tool_frame;
  AttachBy by = AttachBy::kCopy;
  AttachJoint joint = AttachJoint::kFixed;
  double lower = 0, upper = 0;      ///< rad, of a revolute joint
  double effort = 0, velocity = 0;  ///< N·m and rad/s, the same
  std::string
      prefix;  ///< for the gripper's names; empty: none, or its name and `_` where one is taken
};

/// Refused: models of two formats, or, copied, of two versions of SDF; a gripper that is fixed to the world or has
/// several roots; of a template as the arm, a gripper that includes badly: with names that are taken, or relative paths.
Change attached(ModelReader& reader, const EditedModel& arm, const EditedModel& gripper,
                const AttachRequest& request);

}  // namespace rigor::author
