// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/repair/pinch.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

#include <rigor/mesh/repair/pinch_round.h>
#include <rigor/mesh/topology/bad_edges.h>
#include <rigor/mesh/topology/boundary.h>

namespace rigor::mesh {
namespace {

// A round leaves alone what touches something that it mended, so a few are needed; each looks at the
// whole surface again, so a file must not decide how many.
constexpr int kMaxPinchRounds = 8;

constexpr std::uint32_t kUnused = 0xffffffffU;

bool along_places(const BadEdge& a, const BadEdge& b) {
  return std::pair(a.low, a.high) < std::pair(b.low, b.high);
}

}  // namespace

PinchedSurface::PinchedSurface(std::vector<Vector3> places,
                               std::vector<std::uint32_t> place_of_vertex)
    : places_(std::move(places)), place_(std::move(place_of_vertex)), number_(places_.size()) {}

void PinchedSurface::take(std::vector<Triangle> faces) {
  faces_ = std::move(faces);
  std::erase_if(faces_, [&](const Triangle& t) {
    return degenerate({place_[t[0]], place_[t[1]], place_[t[2]]});
  });
  std::vector<bool> used(places_.size());
  for (const Triangle& t : faces_) {
    for (const std::uint32_t vertex : t) used[place_[vertex]] = true;
  }
  used_.clear();
  mesh_.positions.clear();
  for (std::uint32_t place = 0; place < used.size(); ++place) {
    number_[place] = kUnused;
    if (used[place]) number(place);
  }
  number_corners();
}

std::uint32_t PinchedSurface::number(std::uint32_t place) {
  if (number_[place] == kUnused) {
    number_[place] = static_cast<std::uint32_t>(used_.size());
    used_.push_back(place);
    mesh_.positions.push_back(places_[place]);
  }
  return number_[place];
}

void PinchedSurface::number_corners() {
  mesh_.triangles.clear();
  mesh_.triangles.reserve(faces_.size());
  for (const Triangle& t : faces_) {
    mesh_.triangles.push_back(
        {number_[place_[t[0]]], number_[place_[t[1]]], number_[place_[t[2]]]});
  }
}

/// Of the places in use, none with another.
Weld PinchedSurface::apart() const {
  Weld apart;
  apart.place.resize(used_.size());
  std::iota(apart.place.begin(), apart.place.end(), 0U);
  apart.first = apart.place;
  return apart;
}

std::vector<BadEdge> PinchedSurface::bad_edges() const {
  std::vector<BadEdge> edges = bad_edges_of(mesh_, apart());
  for (BadEdge& edge : edges) {
    std::tie(edge.low, edge.high) = std::minmax(used_[edge.low], used_[edge.high]);
  }
  // Places that came into use later have greater numbers.
  if (!std::is_sorted(edges.begin(), edges.end(), along_places)) {
    std::sort(edges.begin(), edges.end(), along_places);
  }
  return edges;
}

BadEdge PinchedSurface::numbered(BadEdge edge) const {
  edge.low = number_[edge.low];
  edge.high = number_[edge.high];
  return edge;
}

std::uint64_t PinchedSurface::holes(std::vector<BadEdge> edges) const {
  for (BadEdge& edge : edges) edge = numbered(edge);
  return boundary_of(mesh_, apart(), edges).loops;
}

std::vector<BadEdge> PinchedSurface::mend(std::vector<BadEdge> edges, const Chosen& chosen) {
  return in_rounds(std::move(edges), chosen,
                   [](PinchRound& round, const BadEdge& edge) { return round.mend(edge); });
}

std::vector<BadEdge> PinchedSurface::part(std::vector<BadEdge> edges, const Chosen& chosen,
                                          const std::vector<std::uint32_t>& corners,
                                          std::size_t most) {
  const auto pinched = [&](const BadEdge& edge) {
    return edge.defect == Defect::kNonmanifoldEdge && chosen(edge);
  };
  if (std::none_of(edges.begin(), edges.end(), pinched)) return edges;
  const std::vector<OldNeighbor> old = old_neighbors(edges, pinched, corners);
  std::size_t room = most - std::min(most, faces_.size());
  return in_rounds(std::move(edges), pinched, [&](PinchRound& round, const BadEdge& edge) {
    if (room < 2 || !round.part(edge, old)) return false;
    room -= 2;
    return true;
  });
}

std::vector<BadEdge> PinchedSurface::in_rounds(std::vector<BadEdge> edges, const Chosen& chosen,
                                               const Step& step) {
  std::vector<BadEdge> open;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(open), chosen);
  for (int round = 0; round < kMaxPinchRounds && !open.empty(); ++round) {
    PinchRound pass(faces_, mesh_);
    bool mended = false;
    for (const BadEdge& edge : open) {
      if (step(pass, numbered(edge))) mended = true;
    }
    if (!mended) break;
    std::erase_if(open, [&](const BadEdge& edge) { return !pass.changed_at(numbered(edge)); });
    faces_ = pass.rest();
    number_corners();
    edges = bad_edges();
    std::erase_if(open, [&](const BadEdge& edge) {
      return !std::binary_search(edges.begin(), edges.end(), edge, along_places);
    });
  }
  return edges;
}

/// Of the vertices at the ends of the chosen edges. Gives their places a number.
std::vector<OldNeighbor> PinchedSurface::old_neighbors(const std::vector<BadEdge>& edges,
                                                       const Chosen& chosen,
                                                       const std::vector<std::uint32_t>& corners) {
  std::vector<bool> at_end(places_.size());
  for (const BadEdge& edge : edges) {
    if (chosen(edge)) at_end[edge.low] = at_end[edge.high] = true;
  }
  std::vector<OldNeighbor> old;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t vertex = corners[i];
    if (!at_end[place_[vertex]]) continue;
    const std::size_t first = i - i % 3;
    for (const std::size_t other : {first + (i - first + 1) % 3, first + (i - first + 2) % 3}) {
      const std::uint32_t place = place_[corners[other]];
      old.push_back({vertex, corners[other], number(place)});
    }
  }
  std::sort(old.begin(), old.end());
  old.erase(std::unique(old.begin(), old.end()), old.end());
  return old;
}

}  // namespace rigor::mesh
