// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a file with its includes says of all its bodies; a file that is attached has a scope of its own.

#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include <rigor/read/mjcf/mjcf_assets.h>
#include <rigor/read/mjcf/mjcf_defaults.h>
#include <rigor/read/mjcf/mjcf_settings.h>
#include <rigor/read/mjcf/mjcf_tree.h>

namespace rigor::read {

struct MjcfScope {
  MjcfScope(Workspace& workspace, const File& file, std::string names_prefix, MjcfFacts& facts);

  MjcfTree tree;
  MjcfSettings settings;
  MjcfDefaults defaults;
  MjcfAssets assets;
  std::string prefix;                           ///< of all its names
  std::set<std::string, std::less<>> in_pairs;  ///< geoms that contact pairs name
};

/// Where an element is: in a body, at a pose that frames and copies around it make.
struct MjcfPlace {
  MjcfScope* scope = nullptr;
  model::Id<model::Link> link;  ///< of the body; none in a world without shapes
  bool in_world = false;
  model::Pose X_BF;  ///< of the frame that poses are written in
  std::size_t class_id = MjcfDefaults::kMain;
  std::string suffix;  ///< of names, by replicate
};

}  // namespace rigor::read
