// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What MuJoCo does with the meshes of a URDF: which it reads, and where it looks for them.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/rules/context.h>
#include <rigor/text/path.h>

namespace rigor::rules {

/// `<mujoco><compiler …/></mujoco>` in a URDF, with the values that MuJoCo takes for one that says nothing.
struct MujocoCompiler {
  bool strip_path = true;      ///< folders, and package://, are cut off
  bool discard_visual = true;  ///< visuals, and their meshes, are not read
  std::string mesh_folder;     ///< beside the URDF
};

inline MujocoCompiler mujoco_compiler(const model::Root& root) {
  MujocoCompiler settings;
  const auto* compiler = find(root.mujoco, "compiler");
  if (compiler == nullptr) return settings;
  const auto is = [compiler](std::string_view name, std::string_view value) {
    const auto* given = attribute(*compiler, name);
    return given != nullptr && given->value == value;
  };
  settings.strip_path = !is("strippath", "false");
  settings.discard_visual = !is("discardvisual", "false");
  for (const std::string_view name : {"assetdir", "meshdir"}) {
    if (const auto* folder = attribute(*compiler, name)) settings.mesh_folder = folder->value;
  }
  return settings;
}

/// A mesh that MuJoCo reads.
struct MujocoMesh {
  const model::Mesh* mesh;
  std::string subject;
};

/// Those of the file itself, collisions first.
inline std::vector<MujocoMesh> mujoco_meshes(const MujocoCompiler& settings,
                                             const Context& context) {
  std::vector<MujocoMesh> meshes;
  const auto add = [&](const auto& shapes) {
    for (const auto& shape : shapes) {
      const auto* mesh = std::get_if<model::Mesh>(&shape.geometry.shape);
      if (mesh == nullptr || mesh->uri.value.empty()) continue;
      meshes.push_back({mesh, context.subject(shape)});
    }
  };
  add(context.root().collisions);
  if (!settings.discard_visual) add(context.root().visuals);
  return meshes;
}

inline bool mujoco_reads(std::string_view uri) {
  const std::string ending = extension(uri);
  return ending == ".stl" || ending == ".obj" || ending == ".msh";
}

}  // namespace rigor::rules
