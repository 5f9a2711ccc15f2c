// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_not_watertight {

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  if (topology.boundary_edges == 0) return;
  const mesh::Boundary& boundary = topology.boundary;
  std::string message =
      "the mesh is open: " + how_many(topology.boundary_edges, "edge has", "edges have") +
      " one triangle only, " + length_in(file, boundary.total_length) + " in all";
  if (boundary.loops > 1) {
    message += fmt::format(", in {} loops, the longest of {}", boundary.loops,
                           how_many(boundary.longest_edges, "edge"));
  }
  message += at_defects(topology, mesh::Defect::kBoundaryEdge, topology.boundary_edges);
  report_mesh(file, context, std::move(message));
}

Rule rule() {
  return {
      .name = "mesh-not-watertight",
      .severity = Severity::kInfo,
      .summary = "a mesh is open: it has edges with one triangle only",
      .why = "What an open surface encloses is not defined: a volume, mass or inertia from it "
             "depends on where the holes are. MuJoCo's exact inertia and Gazebo's automatic one "
             "take such a mesh without a word. Contacts with a hull do not mind.",
      .what_to_do =
          "Close the holes in the tool that made it, or `rigor mesh-check FILE --repair -o OUT`. "
          "For a collision a hull often does: `rigor mesh-check FILE --convex-hull -o OUT`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_not_watertight
