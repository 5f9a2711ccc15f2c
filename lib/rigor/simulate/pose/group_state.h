// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Poses that the author of a robot gave names: `<group_state>` of an SRDF, as MoveIt reads it.
//
//   for (const GroupState& state : group_states("robots/hyq.urdf", "hyq", workspace)) stand(state.positions);

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/read/workspace.h>

namespace rigor::simulate {

struct GroupState {
  std::string name;                                       ///< "standing"
  std::string file;                                       ///< the SRDF's name, without its folder
  std::vector<std::pair<std::string, double>> positions;  ///< of joints with one axis, rad or m
};

/// States that name a stance ("standing", "stand", "half_sitting", "home", "default", "initial", in that order) of the
/// SRDFs of a robot: beside its file, and in `srdf` and `config` beside it or beside its folder. States of one name, of
/// several groups, are one. Those of other robots are ignored, as is what is not well-formed.
std::vector<GroupState> group_states(const std::string& model_path, std::string_view robot,
                                     read::Workspace& workspace);

}  // namespace rigor::simulate
