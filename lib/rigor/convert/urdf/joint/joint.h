// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An SDF joint as URDF says it. What URDF lacks is several joints in a row, through links
// of next to no mass (between.h):
//
//   universal, revolute2   two revolute joints: the same motion
//   ball                   continuous joints about z, y and x: the same but for its singularities
//   screw                  a revolute one and a prismatic one that mimics it
//
// Private to the room.

#pragma once

#include <cstddef>
#include <string>

#include <rigor/convert/urdf/draft.h>
#include <rigor/convert/urdf/joint/mimic.h>
#include <rigor/convert/urdf/robot.h>
#include <rigor/model/model.h>

namespace rigor::convert {

/// How many joints represent one of this type.
std::size_t urdf_joint_count(model::JointType type);

/// Where a joint goes in the target.
struct UrdfJointPlace {
  std::string parent, child;       ///< links
  model::Id<model::Link> carried;  ///< the child
  UrdfOrigin origin;               ///< of the joint in the parent's frame
  bool turned = false;             ///< the parent is the file's child
};

/// Adds the joints and the links between them to the draft, and takes what the joint says of itself but
/// for its pose and mimic.
void add_joint(UrdfDraft& draft, model::Id<model::Joint> joint, const UrdfJointNames& names,
               const UrdfJointPlace& place);

}  // namespace rigor::convert
