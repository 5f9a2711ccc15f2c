// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/rings.h>

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

namespace rigor::mesh {
namespace {

// In longer rings sorting beats searching.
constexpr std::size_t kMaxWalk = 32;

/// A triangle seen from one of its places: it leads from `next` to `previous`.
struct Corner {
  std::uint32_t next;
  std::uint32_t previous;
  std::uint32_t face;
};

using Ring = std::span<const Corner>;

/// The triangles at each place, in their order.
class FacesAt {
 public:
  FacesAt(const TriangleMesh& mesh, const Weld& welded) : end_(welded.places() + 1) {
    for (const Triangle& t : mesh.triangles) {
      const Triangle p = places_of(welded, t);
      if (degenerate(p)) continue;
      for (const std::uint32_t place : p) ++end_[place + 1];
    }
    for (std::size_t i = 1; i < end_.size(); ++i) end_[i] += end_[i - 1];
    faces_ = std::make_unique_for_overwrite<std::uint32_t[]>(end_.back());
    // Filling moves each place's begin to its end, which is the next one's begin.
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
      const Triangle p = places_of(welded, mesh.triangles[face]);
      if (degenerate(p)) continue;
      for (const std::uint32_t place : p) faces_[end_[place]++] = face;
    }
  }

  std::span<const std::uint32_t> operator[](std::uint32_t place) const {
    const std::uint32_t begin = place == 0 ? 0 : end_[place - 1];
    return {faces_.get() + begin, faces_.get() + end_[place]};
  }

 private:
  std::vector<std::uint32_t> end_;
  std::unique_ptr<std::uint32_t[]> faces_;
};

/// Whether each triangle leads to another across one edge, until after all of them the first comes
/// again. Each search takes the first that fits, so a second one that does is never reached, and the
/// walk is short. A ring of two is a triangle on the back of another.
bool closed_fan(Ring ring) {
  if (ring.size() < 3 || ring.size() > kMaxWalk) return false;
  std::size_t at = 0;
  for (std::size_t steps = 1;; ++steps) {
    const std::uint32_t wanted = ring[at].next;
    std::size_t found = 0;
    while (found < ring.size() && ring[found].previous != wanted) ++found;
    if (found == ring.size()) return false;
    if (found == 0) return steps == ring.size();
    if (steps == ring.size()) return false;
    at = found;
  }
}

class RingPass {
 public:
  RingPass(const TriangleMesh& mesh, const Weld& welded, DefectTally& tally)
      : mesh_(mesh), welded_(welded), tally_(tally) {
    rings_.faces = DisjointSets(mesh.triangles.size());
  }

  Rings run() {
    const FacesAt faces(mesh_, welded_);
    std::vector<Corner> ring;
    for (std::uint32_t place = 0; place < welded_.places(); ++place) {
      ring.clear();
      for (const std::uint32_t face : faces[place]) ring.push_back(corner(place, face));
      if (ring.empty()) continue;
      ++rings_.vertices;
      if (closed_fan(ring)) {
        take_sound(place, ring);
      } else {
        take_other(place, ring);
      }
    }
    return std::move(rings_);
  }

 private:
  /// One end of an edge's triangle: `outward` when the triangle runs from the ring's place to `to`.
  struct Spoke {
    std::uint32_t to;
    std::uint32_t corner;
    bool outward;
  };

  Corner corner(std::uint32_t place, std::uint32_t face) const {
    const Triangle p = places_of(welded_, mesh_.triangles[face]);
    if (p[0] == place) return {p[1], p[2], face};
    if (p[1] == place) return {p[2], p[0], face};
    return {p[0], p[1], face};
  }

  const Vector3& position(std::uint32_t place) const {
    return mesh_.positions[welded_.first[place]];
  }

  void take_sound(std::uint32_t place, Ring ring) {
    for (const Corner& corner : ring) {
      rings_.edges += corner.next > place ? 1 : 0;
      rings_.faces.join(ring.front().face, corner.face);
    }
  }

  void take_other(std::uint32_t place, Ring ring) {
    spokes_.clear();
    for (std::uint32_t i = 0; i < ring.size(); ++i) {
      spokes_.push_back({ring[i].next, i, true});
      spokes_.push_back({ring[i].previous, i, false});
    }
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
      return std::pair(a.to, a.corner) < std::pair(b.to, b.corner);
    });
    DisjointSets fan(ring.size());
    std::size_t fans = ring.size();
    for (std::size_t begin = 0; begin < spokes_.size();) {
      std::size_t end = begin;
      for (; end < spokes_.size() && spokes_[end].to == spokes_[begin].to; ++end) {
        fans -= fan.join(spokes_[begin].corner, spokes_[end].corner) ? 1 : 0;
        rings_.faces.join(ring[spokes_[begin].corner].face, ring[spokes_[end].corner].face);
      }
      if (spokes_[begin].to > place) take_edge(place, ring, {&spokes_[begin], end - begin});
      begin = end;
    }
    if (fans > 1) {
      tally_.add(Defect::kNonmanifoldVertex, welded_.first[place], [&] { return position(place); });
    }
    take_duplicates(place, ring);
  }

  void take_edge(std::uint32_t place, Ring ring, std::span<const Spoke> spokes) {
    ++rings_.edges;
    if (spokes.size() == 2 && spokes[0].outward != spokes[1].outward) return;
    const Defect defect = spokes.size() == 1   ? Defect::kBoundaryEdge
                          : spokes.size() == 2 ? Defect::kInconsistentEdge
                                               : Defect::kNonmanifoldEdge;
    const BadEdge edge{place, spokes.front().to, ring[spokes.front().corner].face, defect};
    rings_.bad_edges.push_back(edge);
    tally_.add(defect, edge.face, [&] { return 0.5 * (position(edge.low) + position(edge.high)); });
  }

  /// Of the triangles whose lowest place this is.
  void take_duplicates(std::uint32_t place, Ring ring) {
    opposite_.clear();
    for (const Corner& c : ring) {
      const auto [low, high] = std::minmax(c.next, c.previous);
      if (low > place) opposite_.push_back({low, high, c.face});
    }
    std::sort(opposite_.begin(), opposite_.end());
    for (std::size_t i = 1; i < opposite_.size(); ++i) {
      const Triangle& here = opposite_[i];
      if (here[0] != opposite_[i - 1][0] || here[1] != opposite_[i - 1][1]) continue;
      tally_.add(Defect::kDuplicateFace, here[2],
                 [&] { return middle(facet(mesh_, mesh_.triangles[here[2]])); });
    }
  }

  const TriangleMesh& mesh_;
  const Weld& welded_;
  DefectTally& tally_;
  Rings rings_;
  std::vector<Spoke> spokes_;
  std::vector<Triangle> opposite_;  // the other two places, in order, and the face
};

}  // namespace

Rings look_round(const TriangleMesh& mesh, const Weld& welded, DefectTally& tally) {
  return RingPass(mesh, welded, tally).run();
}

}  // namespace rigor::mesh
