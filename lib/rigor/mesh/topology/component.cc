// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/component.h>

#include <algorithm>

namespace rigor::mesh {
namespace {

/// The volume is that of the tetrahedra from `from` to the triangles.
void add(const Facet& facet, const Vector3& from, Component& to) {
  Bounds& bounds = to.bounds;
  for (const Vector3& p : facet) {
    bounds.min = {std::min(bounds.min.x, p.x), std::min(bounds.min.y, p.y),
                  std::min(bounds.min.z, p.z)};
    bounds.max = {std::max(bounds.max.x, p.x), std::max(bounds.max.y, p.y),
                  std::max(bounds.max.z, p.z)};
  }
  const auto relative = [&from](const Vector3& p) {
    return Vector3{p.x - from.x, p.y - from.y, p.z - from.z};
  };
  const Vector3 a = relative(facet[0]);
  const Vector3 b = relative(facet[1]);
  const Vector3 c = relative(facet[2]);
  to.volume += (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
                a.z * (b.x * c.y - b.y * c.x)) /
               6;
  ++to.triangles;
}

/// Numbers the groups in the order of their first triangles.
Components label(const TriangleMesh& mesh, const Weld& welded, DisjointSets& groups) {
  Components found;
  found.of_face.assign(mesh.triangles.size(), kNoComponent);
  std::uint32_t count = 0;
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    if (degenerate(places_of(welded, mesh.triangles[face]))) continue;
    const std::uint32_t first = groups.find(face);  // the least of its group, so it has a number
    found.of_face[face] = first == face ? count++ : found.of_face[first];
  }
  found.list.resize(count);
  return found;
}

}  // namespace

Components components_of(const TriangleMesh& mesh, const Weld& welded, Rings& rings) {
  Components found = label(mesh, welded, rings.faces);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (found.of_face[i] == kNoComponent) continue;
    Component& component = found.list[found.of_face[i]];
    const Facet corners = facet(mesh, mesh.triangles[i]);
    if (component.triangles == 0) {
      component.first_face = i;
      component.bounds = {corners[0], corners[0]};
    }
    const Vector3& from = mesh.positions[mesh.triangles[component.first_face][0]];
    add(corners, from, component);
  }
  for (const BadEdge& edge : rings.bad_edges) found.list[found.of_face[edge.face]].closed = false;
  return found;
}

}  // namespace rigor::mesh
