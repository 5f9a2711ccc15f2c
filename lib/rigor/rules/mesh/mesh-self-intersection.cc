// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <vector>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_self_intersection {

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape || !shape->self_intersections || shape->self_intersections->pairs == 0) return;
  const mesh::SelfIntersections& found = *shape->self_intersections;
  std::vector<model::Vector3> places;
  for (const mesh::Intersection& pair : found.examples) places.push_back(pair.at);
  const bool all = found.complete && found.pairs < mesh::kMaxIntersectingPairs;
  report_mesh(
      file, context,
      fmt::format("the mesh goes through itself: {}{} of triangles meet{}", all ? "" : "at least ",
                  how_many(found.pairs, "pair"), at_places(places, found.pairs)));
}

Rule rule() {
  return {
      .name = "mesh-self-intersection",
      .severity = Severity::kInfo,
      .summary = "a mesh goes through itself",
      .why =
          "Where parts overlap, a volume or inertia from the triangles counts the overlap twice. "
          "Contacts and pictures do not mind. Assemblies exported as one mesh look like this.",
      .what_to_do = "For mass properties unite the parts in the tool that made them, or take a "
                    "hull: `rigor mesh-check FILE --convex-hull -o OUT`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_self_intersection
