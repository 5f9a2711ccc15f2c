// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh cut into several, each for a file of its own. Every triangle goes to one of them, in the
// order it had, with what its corners carry; each has the positions and materials that it uses.
//
//   Split split = split_by_component(mesh);
//   if (split.too_many()) say(split.count, kMaxSplit);
//   for (const SplitPiece& piece : split.pieces) write(piece.name, piece.mesh);

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// More pieces are not made: as files in a folder they would help no one.
inline constexpr std::uint64_t kMaxSplit = 10'000;

struct SplitPiece {
  std::string name;  ///< the component's number from 0, or the material; empty without a material
  TriangleMesh mesh;
};

struct Split {
  std::uint64_t count = 0;         ///< of pieces that there would be
  std::vector<SplitPiece> pieces;  ///< in the order of their first triangles; none when too many

  bool too_many() const { return count > kMaxSplit; }
};

/// By components of triangles that edges join (mesh/topology/component.h), a cavity being one of its own. A
/// degenerate triangle, which is in none, goes with the triangle before it.
Split split_by_component(const TriangleMesh& mesh);

/// By the names of materials. Parts and triangles of one material need not stand together.
Split split_by_material(const TriangleMesh& mesh);

}  // namespace rigor::mesh
