// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What must be true of a mesh that was read, whatever the bytes were.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <rigor/mesh/read.h>

namespace rigor::fuzz {

/// Whether it is empty with a reason, or a mesh.
inline bool sound(const mesh::LoadedMesh& loaded) {
  const mesh::TriangleMesh& mesh = loaded.mesh;
  const std::size_t count = mesh.triangles.size();
  const auto of_corners = [count](const auto& list) {
    return list.empty() || list.size() == count;
  };
  return loaded.usable() != mesh.triangles.empty() &&
         std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const mesh::Triangle& t) {
                       return std::max({t[0], t[1], t[2]}) < mesh.positions.size();
                     }) &&
         std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [](const model::Vector3& p) {
                       return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
                     }) &&
         of_corners(mesh.corners.texture) && of_corners(mesh.corners.normals) &&
         of_corners(mesh.corners.colors);
}

/// Stops the run unless it is sound.
inline void expect_sound(const mesh::LoadedMesh& loaded) {
  if (!sound(loaded)) __builtin_trap();
}

}  // namespace rigor::fuzz
