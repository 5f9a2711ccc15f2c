// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh file that a model uses, as a list of what was opened tells of it.
//
//   for (const mass::OpenedMesh& mesh : result.files[0].meshes) say(mesh.path + ' ' + mesh.digest);

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <rigor/model/pose.h>

namespace rigor::mass {

struct OpenedMesh {
  std::string path;
  /// Of the file's bytes: 128 bits of XXH3 as 32 hexadecimal digits, for telling files apart. It is no cryptographic hash.
  std::string digest;
  std::uint64_t bytes = 0;
  std::optional<std::uint64_t> triangles =
      {};  ///< nothing when the file could not be read as a mesh
  /// Corners of its bounds, before any scale of the model; m, or the file's own unit where the format has none.
  std::optional<model::Vector3> min = {};
  std::optional<model::Vector3> max = {};

  bool operator==(const OpenedMesh&) const = default;
};

}  // namespace rigor::mass
