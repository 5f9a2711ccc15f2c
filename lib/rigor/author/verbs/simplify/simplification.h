// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh that collides, what stands in for it or why nothing does, and the line that says so. Private to the room.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rigor/mesh/substitute/substitute.h>
#include <rigor/model/model.h>

namespace rigor::author {

using PartId = std::variant<model::Id<model::Collision>, model::Id<model::Visual>>;

/// A mesh to be replaced: a collision's, or a visual's of a link without one.
struct Simplification {
  std::uint32_t body = 0;
  std::size_t index = 0;  ///< among the body's collisions, or visuals
  PartId part;
  const model::PoseField* pose = nullptr;
  const model::Geometry* geometry = nullptr;
  model::Site site;
  std::string name;  ///< "collision arm/hull"
  mesh::SubstituteKind first = mesh::SubstituteKind::kPrimitive;
  std::shared_ptr<const mesh::Substitute> found;
  std::vector<std::string> uris;  ///< of the new meshes
  std::string why;                ///< it is left as it is
  double link_size = 0;           ///< m
  std::size_t triangles = 0;      ///< before

  const model::Mesh& old_mesh() const { return std::get<model::Mesh>(geometry->shape); }
  bool is_new() const { return std::holds_alternative<model::Id<model::Visual>>(part); }
};

/// "collision arm/hull: cylinder for 256 triangles: 0.001 m off (0.1 % of the link), volume +0.2 %", or why it is left.
std::string note(const Simplification& part);

/// In the name of a new mesh: `hull`, `piece` or `reduced`.
std::string_view file_suffix(mesh::SubstituteKind kind);

}  // namespace rigor::author
