// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh under repair: triangles are added, taken away and turned, and after each change it is known
// how many defects there are. A change that makes anything worse can be undone.
//
// Vertices are places: positions are welded exactly at the start, and stay where they are. What the
// triangles carry follows them into the finished mesh.
//
//   Workpiece work(std::move(mesh));
//   bool done = work.attempt([&] { work.remove(face); });
//   mesh = std::move(work).finished();

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <rigor/mesh/topology/topology.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// As in `Topology`.
struct DefectCounts {
  std::uint64_t boundary_edges = 0;
  std::uint64_t nonmanifold_edges = 0;
  std::uint64_t inconsistent_edges = 0;
  std::uint64_t nonmanifold_vertices = 0;
  std::uint64_t degenerate = 0;
  std::uint64_t zero_area = 0;
  std::uint64_t slivers = 0;
  std::uint64_t duplicates = 0;

  bool operator==(const DefectCounts&) const = default;
};

DefectCounts counts_of(const Topology& topology);

/// What may not get worse by a change.
enum class Care : std::uint8_t {
  kAll,
  /// All but edges that two triangles run along the same way, for each of which there must be one bad
  /// edge less of another kind. Turning triangles mends those.
  kAllButWinding,
  kNothing,  ///< whoever works looks at the end
};

/// Whether there is more of any in `after` but slivers: a narrow gap can only be closed by them.
bool worse(const DefectCounts& before, const DefectCounts& after, Care care = Care::kAll);

/// The triangles at an edge: how many, and the first two of them. Counting stops at the third: an edge may have
/// hundreds of thousands, and each would ask.
struct EdgeFaces {
  std::uint32_t count = 0;  ///< 3 for more
  std::array<std::uint32_t, 2> faces{};
};

class Workpiece {
 public:
  explicit Workpiece(TriangleMesh mesh);

  void take(Care care) { care_ = care; }

  /// From now on, attempts that change this triangle, or add one beside it, fail.
  void protect(std::uint32_t face) { protected_[face] = true; }

  /// Triangles are numbered from 0 as in the mesh, then as they were added.
  std::uint32_t size() const { return static_cast<std::uint32_t>(faces_.size()); }
  std::uint32_t vertices() const { return static_cast<std::uint32_t>(faces_at_.size()); }
  bool has(std::uint32_t face) const { return here_[face]; }
  const Triangle& operator[](std::uint32_t face) const { return faces_[face]; }
  const Vector3& at(std::uint32_t vertex) const { return mesh_.positions[vertex]; }
  Facet facet_of(std::uint32_t face) const { return facet(mesh_, faces_[face]); }
  /// Degenerate ones are in neither.
  const std::vector<std::uint32_t>& faces_at(std::uint32_t vertex) const {
    return faces_at_[vertex];
  }
  EdgeFaces faces_at(std::uint32_t a, std::uint32_t b) const;
  const DefectCounts& defects() const { return defects_; }

  /// A new triangle beside another, of whose surface and look it becomes a continuation.
  std::uint32_t add(const Triangle& triangle, std::uint32_t beside);
  /// A new triangle in the place of a part of another.
  std::uint32_t add_piece(const Triangle& triangle, std::uint32_t of);
  void remove(std::uint32_t face);
  void turn(std::uint32_t face);

  /// Makes a change, and takes it back when it made any defect more frequent. Returns whether it stays.
  template <class Change>
  bool attempt(const Change& change) {
    const std::size_t mark = journal_.size();
    const DefectCounts before = defects_;
    const bool already = trespassed_;  // by an attempt that this one is a part of
    trespassed_ = false;
    change();
    const bool stays = !trespassed_ && !worse(before, defects_, care_);
    if (!stays) undo(mark);
    trespassed_ = already;
    return stays;
  }

  /// Attempts may be made until some seconds of work are done; round vertices with many thousand
  /// triangles each one costs much.
  bool tired() const { return work_ > kMaxWork; }

  TriangleMesh finished() &&;

  /// For each triangle of the finished mesh, the mesh's own that it is or was made from.
  std::vector<std::uint32_t> sources() const;

 private:
  static constexpr std::uint64_t kMaxWork = 20'000'000;  // triangles seen at vertices

  enum class Change : std::uint8_t { kAdded, kRemoved, kTurned };
  struct Step {
    Change change;
    std::uint32_t face;
  };
  struct Source {
    std::uint32_t face;  // of the mesh
    bool piece;
  };
  struct Spoke {
    std::uint32_t to;
    std::uint32_t face;  // index among those at the vertex
    bool outward;
  };

  void undo(std::size_t mark);
  Source source_of(std::uint32_t face) const;
  std::uint32_t add(const Triangle& triangle, const Source& source);
  void attach(std::uint32_t face);
  void detach(std::uint32_t face);
  void count_face(std::uint32_t face, std::uint64_t by);
  void count_round(const Triangle& t, std::uint64_t by);
  void count_at(std::uint32_t vertex, std::uint64_t by);
  std::uint64_t duplicates_at(std::uint32_t vertex);

  TriangleMesh mesh_;
  std::vector<Triangle> faces_;
  std::vector<bool> here_;
  std::vector<bool> protected_;
  std::vector<Source> added_;  // from the mesh's last triangle on
  std::vector<std::vector<std::uint32_t>> faces_at_;
  std::vector<Step> journal_;
  std::vector<Spoke> spokes_;
  std::vector<std::array<std::uint32_t, 2>> opposite_;
  DefectCounts defects_;
  std::uint64_t work_ = 0;
  Care care_ = Care::kAll;
  bool trespassed_ = false;  // on a protected triangle, since the attempt began
};

/// Whether the triangle runs from a to b along one of its edges.
inline bool runs(const Triangle& t, std::uint32_t a, std::uint32_t b) {
  return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

/// The corner that is neither a nor b.
inline std::uint32_t apex(const Triangle& t, std::uint32_t a, std::uint32_t b) {
  return t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2];
}

}  // namespace rigor::mesh
