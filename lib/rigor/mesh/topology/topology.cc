// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/topology.h>

#include <utility>

#include <rigor/mesh/topology/nesting.h>
#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/thinness.h>
#include <rigor/mesh/topology/weld.h>

namespace rigor::mesh {
namespace {

void look_at_faces(const TriangleMesh& mesh, const Weld& welded, DefectTally& tally) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Facet corners = facet(mesh, mesh.triangles[i]);
    const auto where = [&corners] { return middle(corners); };
    if (degenerate(places_of(welded, mesh.triangles[i]))) {
      tally.add(Defect::kDegenerateFace, i, where);
      continue;
    }
    const Thinness thin = thinness(corners);
    if (thin == Thinness::kLine) tally.add(Defect::kZeroAreaFace, i, where);
    if (thin == Thinness::kSliver) tally.add(Defect::kSliver, i, where);
  }
}

void look_for_unreferenced(const TriangleMesh& mesh, DefectTally& tally) {
  std::vector<bool> used(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) used[corner] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) tally.add(Defect::kUnreferencedVertex, i, [&] { return mesh.positions[i]; });
  }
}

void take_counts(const DefectTally& tally, Topology& topology) {
  topology.boundary_edges = tally.count(Defect::kBoundaryEdge);
  topology.nonmanifold_edges = tally.count(Defect::kNonmanifoldEdge);
  topology.inconsistent_edges = tally.count(Defect::kInconsistentEdge);
  topology.nonmanifold_vertices = tally.count(Defect::kNonmanifoldVertex);
  topology.degenerate = tally.count(Defect::kDegenerateFace);
  topology.zero_area = tally.count(Defect::kZeroAreaFace);
  topology.slivers = tally.count(Defect::kSliver);
  topology.duplicates = tally.count(Defect::kDuplicateFace);
  topology.unreferenced = tally.count(Defect::kUnreferencedVertex);
  topology.examples = tally.examples();
}

void take_components(std::vector<Component> components, Topology& topology) {
  topology.components = components.size();
  for (const Component& component : components) {
    topology.triangles += component.triangles;
    topology.inverted += component.inverted() ? 1 : 0;
    topology.cavities += component.nesting == Nesting::kCavity ? 1 : 0;
    topology.doubled += component.nesting == Nesting::kDoubled ? 1 : 0;
    topology.not_nested += component.nesting == Nesting::kUnknown ? 1 : 0;
  }
  topology.component_list = std::move(components);
}

}  // namespace

Topology topology_of(const TriangleMesh& mesh) {
  DefectTally tally;
  look_for_unreferenced(mesh, tally);
  const Weld welded = weld(mesh.positions);
  look_at_faces(mesh, welded, tally);
  Rings rings = look_round(mesh, welded, tally);

  Topology topology;
  topology.vertices = rings.vertices;
  topology.edges = rings.edges;
  topology.boundary = boundary_of(mesh, welded, rings.bad_edges);
  Components components = components_of(mesh, welded, rings);
  nest(mesh, components);
  take_counts(tally, topology);
  take_components(std::move(components.list), topology);
  return topology;
}

}  // namespace rigor::mesh
