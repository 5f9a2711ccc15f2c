// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/pinch.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include <rigor/mesh/bad_edges.h>
#include <rigor/mesh/boundary.h>
#include <rigor/mesh/groups.h>

namespace rigor::mesh {
namespace {

// A round leaves alone what touches something that it mended, so a few are needed; each looks at the
// whole surface again, so a file must not decide how many.
constexpr int kMaxPinchRounds = 8;

// More triangles at an edge, or around its ends, are left: trying them in pairs would take too long.
constexpr std::size_t kMaxSide = 16;
constexpr std::size_t kMaxRing = 1024;

// The cosine of the angle by which a turned triangle may lean from the two it comes from.
constexpr double kMinAlong = 0;

using Places = Triangle;

Places places_at(const std::vector<std::uint32_t>& place, const Triangle& vertices) {
  return {place[vertices[0]], place[vertices[1]], place[vertices[2]]};
}

std::size_t corner_of(const Places& face, std::uint32_t place) {
  return static_cast<std::size_t>(std::find(face.begin(), face.end(), place) - face.begin());
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
  Groups groups(ring.size());
  std::size_t apart = ring.size();
  for (std::size_t i = 1; i < spokes.size(); ++i) {
    const bool same = spokes[i].first == spokes[i - 1].first;
    if (same && groups.join(spokes[i].second, spokes[i - 1].second)) --apart;
  }
  return apart;
}

Vector3 area_vector_of(const std::vector<Vector3>& at, const Places& t) {
  return area_vector({at[t[0]], at[t[1]], at[t[2]]});
}

double cosine(const Vector3& a, const Vector3& b) {
  const double lengths = model::length(a) * model::length(b);
  return lengths > 0 ? model::dot(a, b) / lengths : -1;
}

/// Two triangles that share an edge, turned to the other diagonal.
struct Turn {
  std::array<std::uint32_t, 2> faces;
  std::array<Triangle, 2> vertices;
  std::array<Places, 2> places;
  double along = -1;  ///< the lesser cosine between a new normal and that of both old triangles
};

class Round {
 public:
  Round(std::vector<Triangle>& faces, const TriangleMesh& mesh)
      : faces_(faces),
        mesh_(mesh),
        gone_(faces.size()),
        stale_(faces.size()),
        touched_(mesh.positions.size()) {
    begin_.resize(mesh.positions.size() + 1);
    for (const Places& t : mesh.triangles) {
      for (const std::uint32_t place : t) ++begin_[place];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    around_.resize(begin_.back());
    for (std::uint32_t face = 0; face < faces.size(); ++face) {
      for (const std::uint32_t place : mesh.triangles[face]) around_[--begin_[place]] = face;
    }
  }

  /// Returns whether anything was mended.
  bool mend(const BadEdge& edge) {
    const Sides at = sides(edge);
    if (at.upward.size() > kMaxSide || at.downward.size() > kMaxSide) return false;
    return take_back_to_back(edge, at) || take_tetrahedron(edge, at) || turn_two(edge, at);
  }

  std::vector<Triangle> rest() {
    std::vector<Triangle> kept;
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      if (!gone_[face]) kept.push_back(faces_[face]);
    }
    return kept;
  }

 private:
  /// The triangles at an edge, as they run along it.
  struct Sides {
    std::vector<std::uint32_t> upward;  ///< from its lower place to its higher
    std::vector<std::uint32_t> downward;
  };

  std::span<const std::uint32_t> around(std::uint32_t place) const {
    return std::span(around_).subspan(begin_[place], begin_[place + 1] - begin_[place]);
  }

  Sides sides(const BadEdge& edge) const {
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

  std::uint32_t beyond(std::uint32_t face, const BadEdge& edge) const {
    const Places& t = mesh_.triangles[face];
    return t[0] ^ t[1] ^ t[2] ^ edge.low ^ edge.high;  // the place that is neither end
  }

  bool take_back_to_back(const BadEdge& edge, const Sides& at) {
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
  bool take_tetrahedron(const BadEdge& edge, const Sides& at) {
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

  void take(std::uint32_t face) {
    gone_[face] = stale_[face] = true;
    touch(mesh_.triangles[face]);
  }

  std::optional<std::uint32_t> face_of(const Places& wanted) const {
    for (const std::uint32_t face : around(wanted[1])) {
      const Places& t = mesh_.triangles[face];
      const std::size_t i = corner_of(t, wanted[1]);
      if (t[(i + 1) % 3] == wanted[2] && t[(i + 2) % 3] == wanted[0] && !stale_[face]) return face;
    }
    return std::nullopt;
  }

  bool turn_two(const BadEdge& edge, const Sides& at) {
    if (at.upward.size() != 2 || at.downward.size() != 2) return false;
    if (around(edge.low).size() > kMaxRing || around(edge.high).size() > kMaxRing) return false;
    std::optional<Turn> best;
    for (const std::uint32_t up : at.upward) {
      for (const std::uint32_t down : at.downward) {
        const std::optional<Turn> turn = turn_of(up, down, edge);
        if (turn && (!best || turn->along > best->along)) best = turn;
      }
    }
    if (!best) return false;
    for (std::size_t i = 0; i < 2; ++i) {
      faces_[best->faces[i]] = best->vertices[i];
      stale_[best->faces[i]] = true;
      touch(mesh_.triangles[best->faces[i]]);
    }
    return true;
  }

  std::optional<Turn> turn_of(std::uint32_t up, std::uint32_t down, const BadEdge& edge) const {
    if (touched(up) || touched(down)) return std::nullopt;
    const Places& p = mesh_.triangles[up];
    const Places& q = mesh_.triangles[down];
    const std::size_t i = corner_of(p, edge.low);
    const std::size_t j = corner_of(q, edge.high);
    const Triangle a{faces_[up][i], faces_[up][(i + 1) % 3], faces_[up][(i + 2) % 3]};
    const Triangle b{faces_[down][j], faces_[down][(j + 1) % 3], faces_[down][(j + 2) % 3]};
    if (a[0] != b[1] || a[1] != b[0]) return std::nullopt;  // a seam runs along the edge
    Turn turn{{up, down}, {{{a[2], a[0], b[2]}, {b[2], a[1], a[2]}}}, {}};
    const std::uint32_t third = p[(i + 2) % 3];
    const std::uint32_t fourth = q[(j + 2) % 3];
    turn.places = {{{third, edge.low, fourth}, {fourth, edge.high, third}}};
    if (third == fourth || joined(third, fourth)) return std::nullopt;
    if (splits(turn, edge.low) || splits(turn, edge.high)) return std::nullopt;
    const Vector3 before = area_vector_of(mesh_.positions, p) + area_vector_of(mesh_.positions, q);
    turn.along = std::min(cosine(area_vector_of(mesh_.positions, turn.places[0]), before),
                          cosine(area_vector_of(mesh_.positions, turn.places[1]), before));
    if (turn.along < kMinAlong) return std::nullopt;
    return turn;
  }

  bool joined(std::uint32_t a, std::uint32_t b) const {
    const auto faces = around(a);
    return std::any_of(faces.begin(), faces.end(),
                       [&](std::uint32_t face) { return corner_of(mesh_.triangles[face], b) < 3; });
  }

  /// Whether the triangles round a place fall into more fans then.
  bool splits(const Turn& turn, std::uint32_t place) const {
    std::vector<Places> ring;
    for (const std::uint32_t face : around(place)) {
      if (face != turn.faces[0] && face != turn.faces[1]) ring.push_back(mesh_.triangles[face]);
    }
    std::vector<Places> after = ring;
    after.push_back(turn.places[corner_of(turn.places[0], place) < 3 ? 0 : 1]);
    for (const std::uint32_t face : turn.faces) ring.push_back(mesh_.triangles[face]);
    return fans(after, place) > fans(ring, place);
  }

  bool touched(std::uint32_t face) const {
    const Places& t = mesh_.triangles[face];
    return touched_[t[0]] || touched_[t[1]] || touched_[t[2]];
  }

  void touch(const Places& t) { touched_[t[0]] = touched_[t[1]] = touched_[t[2]] = true; }

  std::vector<Triangle>& faces_;
  const TriangleMesh& mesh_;  // of places, as before the round
  std::vector<bool> gone_;
  std::vector<bool> stale_;    // triangles that are no longer what `mesh_` says
  std::vector<bool> touched_;  // places that one of these has or had
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> around_;  // the triangles at each place
};

}  // namespace

PinchedSurface::PinchedSurface(std::vector<Vector3> places,
                               std::vector<std::uint32_t> place_of_vertex)
    : place_(std::move(place_of_vertex)) {
  apart_.place.resize(places.size());
  std::iota(apart_.place.begin(), apart_.place.end(), 0U);
  apart_.first = apart_.place;
  mesh_.positions = std::move(places);
}

void PinchedSurface::take(std::vector<Triangle> faces) {
  std::erase_if(faces, [&](const Triangle& t) { return degenerate(places_at(place_, t)); });
  faces_ = std::move(faces);
  mesh_.triangles.clear();
  mesh_.triangles.reserve(faces_.size());
  for (const Triangle& t : faces_) mesh_.triangles.push_back(places_at(place_, t));
}

std::vector<BadEdge> PinchedSurface::bad_edges() const { return bad_edges_of(mesh_, apart_); }

std::uint64_t PinchedSurface::holes(const std::vector<BadEdge>& edges) const {
  return boundary_of(mesh_, apart_, edges).loops;
}

std::vector<BadEdge> PinchedSurface::mend(std::vector<BadEdge> edges, const Chosen& chosen) {
  for (int round = 0; round < kMaxPinchRounds; ++round) {
    if (std::none_of(edges.begin(), edges.end(), chosen)) break;
    Round pass(faces_, mesh_);
    bool mended = false;
    for (const BadEdge& edge : edges) {
      if (chosen(edge) && pass.mend(edge)) mended = true;
    }
    if (!mended) break;
    take(pass.rest());
    edges = bad_edges();
  }
  return edges;
}

}  // namespace rigor::mesh
