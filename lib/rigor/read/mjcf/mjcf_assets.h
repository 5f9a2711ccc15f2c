// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes, height fields and materials by name, with the paths of their files.

#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/model/model.h>
#include <rigor/read/mjcf/mjcf_defaults.h>
#include <rigor/read/mjcf/mjcf_settings.h>
#include <rigor/read/mjcf/mjcf_tree.h>

namespace rigor::read {

struct MjcfMesh {
  model::Site site;
  model::Mesh mesh;
  /// What `refpos` and `refquat` do: the pose of the file's frame, scaled, in the mesh's frame.
  model::Pose X_RM;
  model::GeomWeight::MeshLaw law = model::GeomWeight::MeshLaw::kLegacy;
  bool sheared = false;   ///< by an uneven scale after a rotation: here it is not
  bool built_in = false;  ///< `builtin`, or by a plugin: rigor does not make its vertices
};

struct MjcfHeightField {
  model::Site site;
  model::Heightmap heightmap;
};

struct MjcfMaterial {
  model::Site site;
  std::array<double, 4> rgba{1, 1, 1, 1};
};

struct MjcfAssets {
  std::map<std::string, MjcfMesh, std::less<>> meshes;
  std::map<std::string, MjcfHeightField, std::less<>> height_fields;
  std::map<std::string, MjcfMaterial, std::less<>> materials;
  std::map<std::string, xml::Element, std::less<>> models;  ///< of attach
};

MjcfAssets mjcf_assets(const MjcfTree& tree, const MjcfSettings& settings,
                       const MjcfDefaults& defaults);

/// The path that an asset's file has relative to the file that names it, so that it resolves like any URI.
std::string mjcf_asset_path(const MjcfTree& tree, const MjcfSettings& settings,
                            xml::Element element, std::string_view folder, std::string_view file);

}  // namespace rigor::read
