// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/solids.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <rigor/mesh/primitive/principal_axes.h>
#include <rigor/mesh/topology/edge_balance.h>
#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/weld.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::mesh {
namespace {

constexpr std::uint32_t kUnnumbered = 0xffffffffU;

/// Pairs of what is inside out and what may hold it, nanoseconds each. With more, none is a cavity.
constexpr std::size_t kMaxNestings = 100'000'000;

/// Of a place, in the mesh that it goes to; of the place that represents a group, of that mesh.
struct Numbers {
  std::uint32_t mesh = kUnnumbered;
  std::uint32_t corner = kUnnumbered;
};

/// Triangles that share a place, each group with positions of its own.
std::vector<TriangleMesh> connected(const TriangleMesh& mesh) {
  const Weld welded = weld(mesh.positions);
  DisjointSets groups(welded.places());
  for (const Triangle& t : mesh.triangles) {
    const Triangle places = places_of(welded, t);
    groups.join(places[0], places[1]);
    groups.join(places[1], places[2]);
  }
  std::vector<TriangleMesh> list;
  std::vector<Numbers> numbers(welded.places());
  for (const Triangle& t : mesh.triangles) {
    Triangle places = places_of(welded, t);
    if (degenerate(places)) continue;
    std::uint32_t& number = numbers[groups.find(places[0])].mesh;
    if (number == kUnnumbered) {
      number = static_cast<std::uint32_t>(list.size());
      list.emplace_back();
    }
    TriangleMesh& part = list[number];
    for (std::uint32_t& place : places) {
      std::uint32_t& corner = numbers[place].corner;
      if (corner == kUnnumbered) {
        corner = static_cast<std::uint32_t>(part.positions.size());
        part.positions.push_back(mesh.positions[welded.first[place]]);
      }
      place = corner;
    }
    part.triangles.push_back(places);
  }
  return list;
}

bool closed(const TriangleMesh& mesh) {
  EdgeBalance balance;
  for (const Triangle& t : mesh.triangles) balance.add(facet(mesh, t));
  return balance.closed();
}

bool bounds_hold(const Bounds& outer, const Bounds& inner) {
  return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.min.z <= inner.min.z &&
         outer.max.x >= inner.max.x && outer.max.y >= inner.max.y && outer.max.z >= inner.max.z;
}

void add_mesh(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto shift = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const Triangle& t : other.triangles) {
    mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
}

struct Body {
  Solid solid;
  Bounds bounds;
};

/// The one of least volume that holds these bounds, and has more volume than the cavity.
Body* smallest_around(std::vector<Body>& bodies, const Bounds& bounds, double volume) {
  Body* best = nullptr;
  for (Body& body : bodies) {
    if (!body.solid.volume || *body.solid.volume <= volume || !bounds_hold(body.bounds, bounds))
      continue;
    if (best == nullptr || *body.solid.volume < *best->solid.volume) best = &body;
  }
  return best;
}

}  // namespace

std::vector<Solid> solids_of(const TriangleMesh& mesh) {
  std::vector<Body> bodies;
  std::vector<Body> inside_out;
  for (TriangleMesh& part : connected(mesh)) {
    const Bounds bounds = bounds_of(part.positions);
    Body body{{std::move(part)}, bounds};
    if (!closed(body.solid.mesh)) {
      bodies.push_back(std::move(body));
      continue;
    }
    body.solid.volume = enclosed_volume(body.solid.mesh);
    if (*body.solid.volume > 0) {
      bodies.push_back(std::move(body));
    } else if (*body.solid.volume < 0) {
      inside_out.push_back(std::move(body));
    }
  }
  const bool look = inside_out.size() <= kMaxNestings / (bodies.size() + inside_out.size() + 1);
  for (Body& cavity : inside_out) {
    const double volume = -*cavity.solid.volume;
    if (Body* around = look ? smallest_around(bodies, cavity.bounds, volume) : nullptr) {
      add_mesh(around->solid.mesh, cavity.solid.mesh);
      *around->solid.volume -= volume;
      continue;
    }
    for (Triangle& t : cavity.solid.mesh.triangles) std::swap(t[1], t[2]);
    cavity.solid.volume = volume;
    bodies.push_back(std::move(cavity));
  }
  std::vector<Solid> solids;
  for (Body& body : bodies) solids.push_back(std::move(body.solid));
  return solids;
}

}  // namespace rigor::mesh
