// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the links of a robot are that urdfdom has read, and what they weigh, at given joint positions.
//
//   const Seen seen = look_at(*urdf::parseURDF(text), {{"elbow", 0.5}});

#pragma once

#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "corpus/judged_conversion.h"

namespace rigor::judge {

inline Rigid rigid_of(const urdf::Pose& X) {
  return {rotation_of(X.rotation.w, X.rotation.x, X.rotation.y, X.rotation.z),
          {X.position.x, X.position.y, X.position.z}};
}

/// A floating or planar joint is held at rest.
inline Rigid motion_of(const urdf::Joint& joint, const std::map<std::string, double>& positions) {
  const auto found = positions.find(joint.name);
  if (found == positions.end()) {
    EXPECT_TRUE(joint.type == urdf::Joint::FIXED || joint.type == urdf::Joint::FLOATING ||
                joint.type == urdf::Joint::PLANAR)
        << joint.name;
    return {};
  }
  const Triple written{joint.axis.x, joint.axis.y, joint.axis.z};
  const Triple axis = (1 / length(written)) * written;
  if (joint.type == urdf::Joint::PRISMATIC) return {kIdentity, found->second * axis};
  EXPECT_TRUE(joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS);
  return {turned(axis, found->second), {}};
}

/// From the root down, a joint at a time.
inline Seen look_at(const urdf::ModelInterface& model,
                    const std::map<std::string, double>& positions) {
  Seen seen;
  std::vector<std::pair<urdf::LinkConstSharedPtr, Rigid>> left{{model.getRoot(), {}}};
  while (!left.empty()) {
    const auto [link, X] = left.back();
    left.pop_back();
    seen.links[link->name] = X;
    if (link->inertial) {
      const urdf::Inertial& i = *link->inertial;
      seen.sum.add(X * rigid_of(i.origin), i.mass, {},
                   {{{i.ixx, i.ixy, i.ixz}, {i.ixy, i.iyy, i.iyz}, {i.ixz, i.iyz, i.izz}}});
    }
    for (const auto& joint : link->child_joints) {
      left.emplace_back(
          model.getLink(joint->child_link_name),
          X * rigid_of(joint->parent_to_joint_origin_transform) * motion_of(*joint, positions));
    }
  }
  return seen;
}

}  // namespace rigor::judge
