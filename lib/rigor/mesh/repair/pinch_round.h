// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// One round of mending pinched edges (pinch.h): what touches something that it mended is left to the
// next.
//
//   PinchRound round(faces, mesh);
//   for (const BadEdge& edge : edges) mended |= round.mend(edge);
//   faces = round.rest();

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// A vertex that was joined to another by a triangle once.
struct OldNeighbor {
  std::uint32_t of;
  std::uint32_t vertex;
  std::uint32_t place;

  friend auto operator<=>(const OldNeighbor&, const OldNeighbor&) = default;
};

class PinchRound {
 public:
  /// The same triangles, of vertices and of places.
  PinchRound(const std::vector<Triangle>& faces, const TriangleMesh& mesh);

  /// Returns whether anything was mended: by triangles that go, or by two that are turned.
  bool mend(const BadEdge& edge);

  /// Puts a vertex that no triangle has into two of the four triangles at an edge, which makes them
  /// four, so that each pair has an edge of its own. It is one of the old neighbors of its ends, which
  /// are sorted. Where nothing else is left, the two pairs only touch at one end then.
  bool part(const BadEdge& edge, std::span<const OldNeighbor> old);

  /// Whether something was mended that its triangles touch: only then may another round do more.
  bool changed_at(const BadEdge& edge) const;

  std::vector<Triangle> rest() const;

 private:
  /// The triangles at an edge, as they run along it.
  struct Sides {
    std::vector<std::uint32_t> upward;  ///< from its lower place to its higher
    std::vector<std::uint32_t> downward;
  };

  /// Two triangles at an edge, each turned until it begins along the edge.
  struct Pair {
    std::array<std::uint32_t, 2> faces;
    std::array<Triangle, 2> vertices;
    std::array<Triangle, 2> places;
  };

  /// What takes their place.
  struct Change {
    std::array<std::uint32_t, 2> faces;
    std::vector<Triangle> vertices;
    std::vector<Triangle> places;
    double along = -1;  ///< the least cosine between a new normal and an old one
  };

  std::span<const std::uint32_t> around(std::uint32_t place) const;
  Sides sides(const BadEdge& edge) const;
  bool few_around(const BadEdge& edge) const;
  std::uint32_t beyond(std::uint32_t face, const BadEdge& edge) const;
  std::optional<std::uint32_t> face_of(const Triangle& wanted) const;
  bool joined(std::uint32_t a, std::uint32_t b) const;
  bool touched(std::uint32_t face) const;
  void touch(const Triangle& places);

  bool take_back_to_back(const BadEdge& edge, const Sides& at);
  bool take_tetrahedron(const BadEdge& edge, const Sides& at);
  void take(std::uint32_t face);

  bool turn_two(const BadEdge& edge, const Sides& at);
  std::optional<Pair> pair_of(std::uint32_t up, std::uint32_t down, const BadEdge& edge) const;
  std::optional<Change> turned(const Pair& pair) const;
  std::optional<Change> parted(const Pair& pair, std::span<const OldNeighbor> old) const;
  bool splits(const Change& change, std::uint32_t place) const;
  bool make(const std::optional<Change>& change);
  Vector3 area_at(const Triangle& places) const;

  std::vector<Triangle> faces_;
  const TriangleMesh& mesh_;  // of places, as before the round
  std::vector<bool> gone_;
  std::vector<bool> stale_;    // triangles that are no longer what `mesh_` says
  std::vector<bool> touched_;  // places that one of these has or had
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> around_;  // the triangles at each place
};

}  // namespace rigor::mesh
