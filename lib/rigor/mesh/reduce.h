// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh of fewer triangles that looks the same: edges are collapsed in the order of the error that
// this makes (meshoptimizer; M. Garland, P. Heckbert, "Surface simplification using quadric error
// metrics", 1997). Vertices of the result are vertices of the mesh, to the last bit.
//
// What the library knows nothing of is done here. A vertex is a place together with what must not
// blur across it, so borders of parts and seams of textures keep their course. Collapses that fold the
// surface onto itself, or pinch it at an edge, are undone (mesh/repair/pinch.h); where that fails, the places
// around are held, and the reduction is done again.
//
//   Reduced reduced = reduce(mesh, {.triangles = mesh.triangles.size() / 10});
//   if (reduced.flaws.any()) say("not all of the surface could be kept together");

#pragma once

#include <cstdint>
#include <limits>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Where the surface ends.
enum class Border : std::uint8_t {
  kFollow,  ///< gets fewer vertices as well
  kHold     ///< keeps each vertex: the mesh still fits another that it ends at
};

/// Where texture or color jump between triangles that share an edge. Borders of parts always stay.
enum class Seams : std::uint8_t {
  kKeep,    ///< though it may cost what lies between them its shape, and not reach what is wanted
  kPrefer,  ///< kept, unless they are in the way of what is wanted, or cost much of the shape
  kIgnore   ///< corners get texture and color of the mesh's most alike corner there
};

struct Reduction {
  std::uint64_t triangles = 0;  ///< to be reached, if the others allow it
  /// Never more than this, in the mesh's unit, by the library's estimate (see `Reduced::error`).
  double max_error = std::numeric_limits<double>::infinity();
  Border border = Border::kFollow;
  Seams seams = Seams::kKeep;
};

/// What the result has more of than the mesh; of non-manifold edges, than the mesh at the same places.
struct Flaws {
  std::uint64_t holes = 0;  ///< loops of edges of one triangle
  std::uint64_t nonmanifold_edges = 0;
  std::uint64_t inconsistent_edges = 0;

  std::uint64_t total() const { return holes + nonmanifold_edges + inconsistent_edges; }
  bool any() const { return total() > 0; }
};

struct Reduced {
  TriangleMesh mesh;  ///< positions are those in use, of different coordinates
  /// How far the surface moved, in the mesh's unit: the root of the greatest quadric error, which is
  /// an average over the triangles around. No bound: measure the distance where it matters.
  double error = 0;
  Flaws flaws;
  std::uint64_t runs = 0;  ///< of the library; more than one when places had to be held
  bool seams_kept = true;
};

/// A mesh of no more triangles than wanted is given back as it is. Degenerate triangles are left out
/// of any other. Normals are the mesh's at that corner, the ones nearest to the new triangle's.
Reduced reduce(const TriangleMesh& mesh, const Reduction& to);

/// Corners of each cell of a grid made one (J. Rossignac, P. Borrel, "Multi-resolution 3D approximations for rendering
/// complex scenes", 1993): what does not hang together, where no edge can be collapsed, gets fewer triangles, too. No
/// surface stays closed. What corners carry is lost.
TriangleMesh reduced_loosely(const TriangleMesh& mesh, std::uint64_t triangles);

}  // namespace rigor::mesh
