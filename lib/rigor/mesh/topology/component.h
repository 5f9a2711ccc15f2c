// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The connected pieces of a mesh's surface: triangles that edges join. Pieces that touch in a vertex
// only are apart.
//
//   Components components = components_of(mesh, welded, rings);
//   if (components.list[0].closed) weigh(components.list[0].volume);

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/weld.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// What a closed component is to the one it lies in.
enum class Nesting : std::uint8_t {
  kBody,     ///< in none, or in a cavity: matter
  kCavity,   ///< turned against the body it is in: takes its inside away
  kDoubled,  ///< turned as the body or cavity it is in: its inside counts twice
  kUnknown   ///< not examined: the work would have passed its bound
};

struct Component {
  std::uint64_t first_face = 0;  ///< its first triangle; components are in this order
  std::uint64_t triangles = 0;
  Bounds bounds;
  double volume = 0;   ///< signed; of an open one, that of the cone to its first corner added
  bool closed = true;  ///< every edge has two triangles, which run along it in opposite directions
  Nesting nesting = Nesting::kBody;
  std::optional<std::uint32_t> inside;  ///< the smallest closed component around it

  bool inverted() const { return closed && volume < 0 && !inside && nesting != Nesting::kUnknown; }
};

struct Components {
  std::vector<Component> list;
  std::vector<std::uint32_t> of_face;  ///< index into the list; `kNoComponent` of degenerate ones
};

inline constexpr std::uint32_t kNoComponent = 0xffffffffU;

Components components_of(const TriangleMesh& mesh, const Weld& welded, Rings& rings);

}  // namespace rigor::mesh
