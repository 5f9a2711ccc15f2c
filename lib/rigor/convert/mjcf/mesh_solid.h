// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh as MuJoCo's compiler takes it: it integrates every mesh, whatever the geom is for, and rejects one
// that encloses nothing or whose triangles disagree about the outside. Private to the room.
//
//   MujocoSolid solid = mujoco_solid(std::move(mesh), collides);
//   if (!solid.mesh) say(solid.problem);

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::convert {

struct MujocoSolid {
  std::optional<mesh::TriangleMesh> mesh;
  bool replaced = false;  ///< whether it is another mesh than the file's
  /// What was done to it, or what MuJoCo does; empty when nothing is.
  std::string change = {};
  std::string_view problem = {};  ///< why there is none
};

enum class MujocoUse : bool { kVisual, kCollision };

MujocoSolid mujoco_solid(mesh::TriangleMesh mesh, MujocoUse use);

/// Nothing where the points lie in a plane.
std::optional<mesh::TriangleMesh> mujoco_hull(const std::vector<mesh::Vector3>& points);

}  // namespace rigor::convert
