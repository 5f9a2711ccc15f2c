// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/repair/pinch_round.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include <rigor/text/disjoint_sets.h>

namespace rigor::mesh {
namespace {

// More triangles at an edge, or around its ends, are left: trying them in pairs would take too long.
constexpr std::size_t kMaxSide = 16;
constexpr std::size_t kMaxRing = 1024;

// The cosine of the angle by which a new triangle may lean from the old ones.
constexpr double kMinAlong = 0;

using Places = Triangle;

std::size_t corner_of(const Places& face, std::uint32_t place) {
  return static_cast<std::size_t>(std::find(face.begin(), face.end(), place) - face.begin());
}

/// With this corner first.
Triangle from_corner(const Triangle& t, std::size_t corner) {
  return {t[corner], t[(corner + 1) % 3], t[(corner + 2) % 3]};
}

/// Into how many fans these triangles round a place fall: those that share an edge there are one.
std::size_t fans(const std::vector<Places>& ring, std::uint32_t place) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> spokes;  // the far end, and whose it is
  for (std::uint32_t i = 0; i < ring.size(); ++i) {
    for (const std::uint32_t end : ring[i]) {
      if (end != place) spokes.emplace_back(end, i);
    }
  }
  std::sort(spokes.begin(), spokes.end());
  DisjointSets groups(ring.size());
  std::size_t apart = ring.size();
  for (std::size_t i = 1; i < spokes.size(); ++i) {
    const bool same = spokes[i].first == spokes[i - 1].first;
    if (same && groups.join(spokes[i].second, spokes[i - 1].second)) --apart;
  }
  return apart;
}

double cosine(const Vector3& a, const Vector3& b) {
  const double lengths = model::length(a) * model::length(b);
  return lengths > 0 ? model::dot(a, b) / lengths : -1;
}

}  // namespace

PinchRound::PinchRound(const std::vector<Triangle>& faces, const TriangleMesh& mesh)
    : faces_(faces),
      mesh_(mesh),
      gone_(faces.size()),
      stale_(faces.size()),
      touched_(mesh.positions.size()),
      begin_(mesh.positions.size() + 1) {
  for (const Places& t : mesh.triangles) {
    for (const std::uint32_t place : t) ++begin_[place];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  around_.resize(begin_.back());
  for (std::uint32_t face = 0; face < faces.size(); ++face) {
    for (const std::uint32_t place : mesh.triangles[face]) around_[--begin_[place]] = face;
  }
}

bool PinchRound::mend(const BadEdge& edge) {
  const Sides at = sides(edge);
  if (at.upward.size() > kMaxSide || at.downward.size() > kMaxSide) return false;
  return take_back_to_back(edge, at) || take_tetrahedron(edge, at) || turn_two(edge, at);
}

bool PinchRound::part(const BadEdge& edge, std::span<const OldNeighbor> old) {
  const Sides at = sides(edge);
  if (at.upward.size() != 2 || at.downward.size() != 2 || !few_around(edge)) return false;
  std::optional<Change> best;
  int least = 0;
  for (const std::uint32_t up : at.upward) {
    for (const std::uint32_t down : at.downward) {
      const std::optional<Pair> pair = pair_of(up, down, edge);
      if (!pair) continue;
      std::optional<Change> change = parted(*pair, old);
      if (!change) continue;
      const int split = splits(*change, edge.low) + splits(*change, edge.high);
      if (best && std::pair(-split, change->along) <= std::pair(-least, best->along)) continue;
      least = split;
      best = std::move(change);
    }
  }
  return make(best);
}

bool PinchRound::changed_at(const BadEdge& edge) const {
  if (touched_[edge.low] || touched_[edge.high]) return true;
  const auto faces = around(edge.low);
  return std::any_of(faces.begin(), faces.end(), [&](std::uint32_t face) {
    return touched(face) && corner_of(mesh_.triangles[face], edge.high) < 3;
  });
}

std::vector<Triangle> PinchRound::rest() const {
  std::vector<Triangle> kept;
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    if (!gone_[face]) kept.push_back(faces_[face]);
  }
  return kept;
}

std::span<const std::uint32_t> PinchRound::around(std::uint32_t place) const {
  return std::span(around_).subspan(begin_[place], begin_[place + 1] - begin_[place]);
}

PinchRound::Sides PinchRound::sides(const BadEdge& edge) const {
  Sides found;
  const bool few_at_low = around(edge.low).size() <= around(edge.high).size();
  for (const std::uint32_t face : around(few_at_low ? edge.low : edge.high)) {
    const Places& t = mesh_.triangles[face];
    const std::size_t low = corner_of(t, edge.low);
    if (low == 3 || stale_[face]) continue;
    if (t[(low + 1) % 3] == edge.high) found.upward.push_back(face);
    if (t[(low + 2) % 3] == edge.high) found.downward.push_back(face);
  }
  return found;
}

bool PinchRound::few_around(const BadEdge& edge) const {
  return around(edge.low).size() <= kMaxRing && around(edge.high).size() <= kMaxRing;
}

/// The place that is neither end.
std::uint32_t PinchRound::beyond(std::uint32_t face, const BadEdge& edge) const {
  const Places& t = mesh_.triangles[face];
  return t[0] ^ t[1] ^ t[2] ^ edge.low ^ edge.high;
}

std::optional<std::uint32_t> PinchRound::face_of(const Places& wanted) const {
  for (const std::uint32_t face : around(wanted[1])) {
    const Places& t = mesh_.triangles[face];
    const std::size_t i = corner_of(t, wanted[1]);
    if (t[(i + 1) % 3] == wanted[2] && t[(i + 2) % 3] == wanted[0] && !stale_[face]) return face;
  }
  return std::nullopt;
}

bool PinchRound::joined(std::uint32_t a, std::uint32_t b) const {
  const auto faces = around(a);
  return std::any_of(faces.begin(), faces.end(),
                     [&](std::uint32_t face) { return corner_of(mesh_.triangles[face], b) < 3; });
}

bool PinchRound::touched(std::uint32_t face) const {
  const Places& t = mesh_.triangles[face];
  return touched_[t[0]] || touched_[t[1]] || touched_[t[2]];
}

void PinchRound::touch(const Places& t) { touched_[t[0]] = touched_[t[1]] = touched_[t[2]] = true; }

bool PinchRound::take_back_to_back(const BadEdge& edge, const Sides& at) {
  for (const std::uint32_t up : at.upward) {
    for (const std::uint32_t down : at.downward) {
      if (beyond(up, edge) != beyond(down, edge)) continue;
      take(up);
      take(down);
      return true;
    }
  }
  return false;
}

/// One that hangs on the surface by the edge.
bool PinchRound::take_tetrahedron(const BadEdge& edge, const Sides& at) {
  for (const std::uint32_t up : at.upward) {
    for (const std::uint32_t down : at.downward) {
      const std::uint32_t x = beyond(up, edge);
      const std::uint32_t y = beyond(down, edge);
      const std::optional<std::uint32_t> third = face_of({edge.low, x, y});
      const std::optional<std::uint32_t> fourth = face_of({edge.high, y, x});
      if (!third || !fourth) continue;
      for (const std::uint32_t face : {up, down, *third, *fourth}) take(face);
      return true;
    }
  }
  return false;
}

void PinchRound::take(std::uint32_t face) {
  gone_[face] = stale_[face] = true;
  touch(mesh_.triangles[face]);
}

bool PinchRound::turn_two(const BadEdge& edge, const Sides& at) {
  if (at.upward.size() != 2 || at.downward.size() != 2 || !few_around(edge)) return false;
  std::optional<Change> best;
  for (const std::uint32_t up : at.upward) {
    for (const std::uint32_t down : at.downward) {
      const std::optional<Pair> pair = pair_of(up, down, edge);
      if (!pair) continue;
      std::optional<Change> change = turned(*pair);
      if (change && (!best || change->along > best->along)) best = std::move(change);
    }
  }
  return make(best);
}

std::optional<PinchRound::Pair> PinchRound::pair_of(std::uint32_t up, std::uint32_t down,
                                                    const BadEdge& edge) const {
  if (touched(up) || touched(down)) return std::nullopt;
  const std::size_t i = corner_of(mesh_.triangles[up], edge.low);
  const std::size_t j = corner_of(mesh_.triangles[down], edge.high);
  Pair pair{{up, down},
            {from_corner(faces_[up], i), from_corner(faces_[down], j)},
            {from_corner(mesh_.triangles[up], i), from_corner(mesh_.triangles[down], j)}};
  const auto& [a, b] = pair.vertices;
  if (a[0] != b[1] || a[1] != b[0]) return std::nullopt;  // a seam runs along the edge
  return pair;
}

/// To the other diagonal of their quadrangle.
std::optional<PinchRound::Change> PinchRound::turned(const Pair& pair) const {
  const auto turn = [](const Triangle& a, const Triangle& b) {
    return std::vector<Triangle>{{a[2], a[0], b[2]}, {b[2], a[1], a[2]}};
  };
  const auto& [p, q] = pair.places;
  if (p[2] == q[2] || joined(p[2], q[2])) return std::nullopt;
  Change change{pair.faces, turn(pair.vertices[0], pair.vertices[1]), turn(p, q)};
  const Vector3 before = area_at(p) + area_at(q);
  change.along = std::min(cosine(area_at(change.places[0]), before),
                          cosine(area_at(change.places[1]), before));
  if (change.along < kMinAlong) return std::nullopt;
  if (splits(change, p[0]) || splits(change, p[1])) return std::nullopt;
  return change;
}

/// By the old neighbor of one of the edge's ends that bends the surface least.
std::optional<PinchRound::Change> PinchRound::parted(const Pair& pair,
                                                     std::span<const OldNeighbor> old) const {
  const auto part = [](const std::array<Triangle, 2>& both, std::uint32_t v) {
    const auto& [a, b] = both;
    return std::vector<Triangle>{
        {a[0], v, a[2]}, {b[0], v, b[2]}, {v, a[1], a[2]}, {v, b[1], b[2]}};
  };
  std::optional<OldNeighbor> best;
  double most = kMinAlong;
  for (const std::uint32_t end : {pair.vertices[0][0], pair.vertices[0][1]}) {
    for (auto n = std::lower_bound(old.begin(), old.end(), OldNeighbor{end, 0, 0});
         n != old.end() && n->of == end; ++n) {
      if (!around(n->place).empty() || touched_[n->place]) continue;
      const std::vector<Triangle> places = part(pair.places, n->place);
      double along = 1;
      for (std::size_t i = 0; i < places.size(); ++i) {
        along = std::min(along, cosine(area_at(places[i]), area_at(pair.places[i % 2])));
      }
      if (along <= most) continue;
      most = along;
      best = *n;
    }
  }
  if (!best) return std::nullopt;
  return Change{pair.faces, part(pair.vertices, best->vertex), part(pair.places, best->place),
                most};
}

/// Whether the triangles round a place fall into more fans then.
bool PinchRound::splits(const Change& change, std::uint32_t place) const {
  std::vector<Places> before;
  std::vector<Places> after;
  for (const std::uint32_t face : around(place)) {
    before.push_back(mesh_.triangles[face]);
    if (face != change.faces[0] && face != change.faces[1]) after.push_back(before.back());
  }
  for (const Places& t : change.places) {
    if (corner_of(t, place) < 3) after.push_back(t);
  }
  return fans(after, place) > fans(before, place);
}

bool PinchRound::make(const std::optional<Change>& change) {
  if (!change) return false;
  for (std::size_t i = 0; i < change->places.size(); ++i) {
    touch(change->places[i]);
    if (i >= 2) {
      faces_.push_back(change->vertices[i]);
      gone_.push_back(false);
      continue;
    }
    faces_[change->faces[i]] = change->vertices[i];
    stale_[change->faces[i]] = true;
  }
  return true;
}

Vector3 PinchRound::area_at(const Places& t) const {
  return area_vector({mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]});
}

}  // namespace rigor::mesh
