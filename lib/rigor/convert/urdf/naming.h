// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of all links and joints of a robot in the making. Private to the room.

#pragma once

#include <map>
#include <string>

#include <rigor/convert/ledger.h>
#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/convert/urdf/joint/mimic.h>
#include <rigor/convert/urdf/names.h>
#include <rigor/convert/urdf/tree.h>
#include <rigor/model/model.h>

namespace rigor::convert {

struct UrdfNaming {
  UrdfNames link_names{"link", {"world"}};
  UrdfNames joint_names{"joint"};
  std::map<model::Id<model::Link>, std::string> links;
  std::map<model::Id<model::Frame>, std::string> frames;  ///< those that become links
  JointNames joints;
};

/// What a thing is called inside the model: "hand::palm" in "arm".
std::string name_inside(const UrdfTree& tree, const model::Root& root, const std::string& scoped);

/// Tells what is called otherwise, and which models were flattened.
UrdfNaming urdf_naming(const Source& source, const UrdfOptions& options, const UrdfTree& tree,
                       Ledger& ledger);

}  // namespace rigor::convert
