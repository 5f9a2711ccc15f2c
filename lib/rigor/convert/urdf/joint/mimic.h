// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Joints that follow others: SDF's `<mimic>` and gearboxes. Private to the room.

#pragma once

#include <map>
#include <string>
#include <vector>

#include <rigor/convert/urdf/draft.h>
#include <rigor/convert/urdf/tree.h>
#include <rigor/model/model.h>

namespace rigor::convert {

/// What an SDF joint is in URDF, from its parent to its child: one joint, or several in a row.
struct UrdfJointNames {
  std::vector<std::string> joints;
  std::vector<std::string> links;  ///< between the joints: one fewer
};
using JointNames = std::map<model::Id<model::Joint>, UrdfJointNames>;

/// Lets joints of the draft follow as their `<mimic>` says; all joints are in the draft.
void add_mimics(UrdfDraft& draft, const UrdfTree& tree, const JointNames& names);

/// Turns a gearbox into a mimic of one of the two joints that it couples; a note where there are none.
void add_gearboxes(UrdfDraft& draft, const UrdfTree& tree, const JointNames& names);

/// Lets a joint that follows a follower follow the leader of both, and tells it.
void flatten_mimics(UrdfDraft& draft, const UrdfTree& tree, const JointNames& names);

}  // namespace rigor::convert
