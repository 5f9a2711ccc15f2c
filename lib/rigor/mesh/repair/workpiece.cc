// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/repair/workpiece.h>

#include <algorithm>
#include <utility>

#include <rigor/mesh/select.h>
#include <rigor/mesh/topology/thinness.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::mesh {
namespace {

constexpr std::uint64_t kMore = 1;
constexpr std::uint64_t kLess = ~std::uint64_t{0};  // -1: counts are added modulo 2^64

bool has_corner(const Triangle& t, std::uint32_t vertex) {
  return t[0] == vertex || t[1] == vertex || t[2] == vertex;
}

/// From the triangle's corner `vertex` on.
std::pair<std::uint32_t, std::uint32_t> others(const Triangle& t, std::uint32_t vertex) {
  if (t[0] == vertex) return {t[1], t[2]};
  if (t[1] == vertex) return {t[2], t[0]};
  return {t[0], t[1]};
}

}  // namespace

DefectCounts counts_of(const Topology& t) {
  return {t.boundary_edges,
          t.nonmanifold_edges,
          t.inconsistent_edges,
          t.nonmanifold_vertices,
          t.degenerate,
          t.zero_area,
          t.slivers,
          t.duplicates};
}

bool worse(const DefectCounts& before, const DefectCounts& after, Care care) {
  if (care == Care::kNothing) return false;
  const auto bad_edges = [](const DefectCounts& c) {
    return c.boundary_edges + c.nonmanifold_edges + c.inconsistent_edges;
  };
  const bool windings = care == Care::kAll ? after.inconsistent_edges > before.inconsistent_edges
                                           : bad_edges(after) > bad_edges(before);
  return windings || after.boundary_edges > before.boundary_edges ||
         after.nonmanifold_edges > before.nonmanifold_edges ||
         after.nonmanifold_vertices > before.nonmanifold_vertices ||
         after.degenerate > before.degenerate || after.zero_area > before.zero_area ||
         after.duplicates > before.duplicates;
}

Workpiece::Workpiece(TriangleMesh mesh) : mesh_(std::move(mesh)) {
  compact(mesh_);
  faces_ = mesh_.triangles;
  here_.assign(faces_.size(), true);
  protected_.assign(faces_.size(), false);
  faces_at_.resize(mesh_.positions.size());
  for (std::uint32_t face = 0; face < size(); ++face) {
    count_face(face, kMore);
    if (degenerate(faces_[face])) continue;
    for (const std::uint32_t corner : faces_[face]) faces_at_[corner].push_back(face);
  }
  for (std::uint32_t vertex = 0; vertex < vertices(); ++vertex) count_at(vertex, kMore);
  work_ = 0;
}

EdgeFaces Workpiece::faces_at(std::uint32_t a, std::uint32_t b) const {
  if (faces_at_[b].size() < faces_at_[a].size()) std::swap(a, b);
  EdgeFaces found;
  for (const std::uint32_t face : faces_at_[a]) {
    if (!has_corner(faces_[face], b)) continue;
    if (found.count == found.faces.size()) {
      ++found.count;
      break;
    }
    found.faces[found.count++] = face;
  }
  return found;
}

Workpiece::Source Workpiece::source_of(std::uint32_t face) const {
  const std::size_t originals = mesh_.triangles.size();
  return face < originals ? Source{face, true} : added_[face - originals];
}

std::uint32_t Workpiece::add(const Triangle& triangle, std::uint32_t beside) {
  return add(triangle, Source{beside, false});
}

std::uint32_t Workpiece::add_piece(const Triangle& triangle, std::uint32_t of) {
  return add(triangle, Source{of, true});
}

std::uint32_t Workpiece::add(const Triangle& triangle, const Source& source) {
  const Source before = source_of(source.face);
  const Source of_mesh{before.face, source.piece && before.piece};
  trespassed_ = trespassed_ || protected_[of_mesh.face];
  const std::uint32_t face = size();
  faces_.push_back(triangle);
  here_.push_back(false);
  added_.push_back(of_mesh);
  attach(face);
  journal_.push_back({Change::kAdded, face});
  return face;
}

void Workpiece::remove(std::uint32_t face) {
  trespassed_ = trespassed_ || protected_[source_of(face).face];
  detach(face);
  journal_.push_back({Change::kRemoved, face});
}

void Workpiece::turn(std::uint32_t face) {
  trespassed_ = trespassed_ || protected_[source_of(face).face];
  Triangle& t = faces_[face];
  for (std::size_t i = 0; i < 3; ++i) {  // of all defects, only the winding at its edges changes
    const std::uint32_t a = t[i];
    const std::uint32_t b = t[(i + 1) % 3];
    const EdgeFaces at = faces_at(a, b);
    if (at.count != 2) continue;
    const std::uint32_t other = at.faces[0] == face ? at.faces[1] : at.faces[0];
    defects_.inconsistent_edges += runs(faces_[other], a, b) ? kLess : kMore;
  }
  std::swap(t[1], t[2]);
  journal_.push_back({Change::kTurned, face});
}

void Workpiece::undo(std::size_t mark) {
  while (journal_.size() > mark) {
    const Step step = journal_.back();
    if (step.change == Change::kTurned) turn(step.face);
    if (step.change == Change::kRemoved) attach(step.face);
    if (step.change == Change::kAdded) {
      if (here_[step.face]) detach(step.face);
      faces_.pop_back();
      here_.pop_back();
      added_.pop_back();
    }
    journal_.resize(journal_.size() - (step.change == Change::kTurned ? 2 : 1));
  }
}

void Workpiece::attach(std::uint32_t face) {
  const Triangle& t = faces_[face];
  here_[face] = true;
  count_face(face, kMore);
  if (degenerate(t)) return;
  count_round(t, kLess);
  for (const std::uint32_t corner : t) faces_at_[corner].push_back(face);
  count_round(t, kMore);
}

void Workpiece::detach(std::uint32_t face) {
  const Triangle& t = faces_[face];
  here_[face] = false;
  count_face(face, kLess);
  if (degenerate(t)) return;
  count_round(t, kLess);
  for (const std::uint32_t corner : t) std::erase(faces_at_[corner], face);
  count_round(t, kMore);
}

void Workpiece::count_face(std::uint32_t face, std::uint64_t by) {
  if (degenerate(faces_[face])) {
    defects_.degenerate += by;
    return;
  }
  const Thinness thin = thinness(facet_of(face));
  if (thin == Thinness::kLine) defects_.zero_area += by;
  if (thin == Thinness::kSliver) defects_.slivers += by;
}

void Workpiece::count_round(const Triangle& t, std::uint64_t by) {
  for (const std::uint32_t corner : t) count_at(corner, by);
}

/// What is wrong at the vertex, at edges to greater ones, and among triangles of which it is the least:
/// so all is counted once (see mesh/topology/rings.h).
void Workpiece::count_at(std::uint32_t vertex, std::uint64_t by) {
  const std::vector<std::uint32_t>& ring = faces_at_[vertex];
  work_ += ring.size();
  spokes_.clear();
  for (std::uint32_t i = 0; i < ring.size(); ++i) {
    const auto [next, previous] = others(faces_[ring[i]], vertex);
    spokes_.push_back({next, i, true});
    spokes_.push_back({previous, i, false});
  }
  std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
    return std::pair(a.to, a.face) < std::pair(b.to, b.face);
  });
  DisjointSets fan(ring.size());
  std::size_t fans = ring.size();
  for (std::size_t begin = 0, end = 0; begin < spokes_.size(); begin = end) {
    for (; end < spokes_.size() && spokes_[end].to == spokes_[begin].to; ++end) {
      fans -= fan.join(spokes_[begin].face, spokes_[end].face) ? 1 : 0;
    }
    if (spokes_[begin].to < vertex) continue;
    const std::size_t count = end - begin;
    if (count == 1) defects_.boundary_edges += by;
    if (count > 2) defects_.nonmanifold_edges += by;
    if (count == 2 && spokes_[begin].outward == spokes_[begin + 1].outward) {
      defects_.inconsistent_edges += by;
    }
  }
  if (fans > 1) defects_.nonmanifold_vertices += by;
  defects_.duplicates += by * duplicates_at(vertex);
}

std::uint64_t Workpiece::duplicates_at(std::uint32_t vertex) {
  opposite_.clear();
  for (const std::uint32_t face : faces_at_[vertex]) {
    const auto [next, previous] = others(faces_[face], vertex);
    if (next > vertex && previous > vertex) {
      opposite_.push_back({std::min(next, previous), std::max(next, previous)});
    }
  }
  std::sort(opposite_.begin(), opposite_.end());
  const auto last = std::unique(opposite_.begin(), opposite_.end());
  return static_cast<std::uint64_t>(opposite_.end() - last);
}

std::vector<std::uint32_t> Workpiece::sources() const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t face = 0; face < size(); ++face) {
    if (here_[face]) found.push_back(source_of(face).face);
  }
  return found;
}

TriangleMesh Workpiece::finished() && {
  const auto originals = static_cast<std::uint32_t>(mesh_.triangles.size());
  std::vector<std::uint32_t> kept;
  for (std::uint32_t face = 0; face < originals; ++face) {
    if (faces_[face] != mesh_.triangles[face]) turn_over(mesh_, face);
    if (here_[face]) kept.push_back(face);
  }
  for (std::uint32_t face = originals; face < size(); ++face) {
    if (!here_[face]) continue;
    kept.push_back(static_cast<std::uint32_t>(mesh_.triangles.size()));
    const Source& source = added_[face - originals];
    if (source.piece) {
      append_piece(mesh_, faces_[face], source.face);
    } else {
      append(mesh_, faces_[face], source.face);
    }
  }
  TriangleMesh mesh = selected(std::move(mesh_), kept);
  compact(mesh);
  return mesh;
}

}  // namespace rigor::mesh
