// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_collision_is_visual {

constexpr std::uint64_t kMany = 5000;  // fewer cost little; 9 of 10 real collisions have half of it

bool is_seen(const model::Link& link, const model::Root& root, const std::string& uri) {
  return std::any_of(link.visuals.begin(), link.visuals.end(), [&](model::Id<model::Visual> id) {
    const auto* mesh = std::get_if<model::Mesh>(&root.visuals[id.value].geometry.shape);
    return mesh && mesh->uri.value == uri;
  });
}

void check(const MeshFile& file, Context& context) {
  if (!file.collision() || takes_part(file) || file.facts.triangles <= kMany) return;
  const model::Link* link = link_of(file, context);
  if (!link || !is_seen(*link, context.root(), file.use->mesh.uri.value)) return;
  report_mesh(file, context,
              fmt::format("the link is seen as this mesh and collides with it: {} triangles",
                          file.facts.triangles));
}

Rule rule() {
  return {
      .name = "mesh-collision-is-visual",
      .severity = Severity::kInfo,
      .summary = "a link collides with the mesh that is seen",
      .why = "What is drawn has detail that contacts do not need and pay for in every step. A mesh "
             "of its own, a hull or primitives are faster and touch more evenly.",
      .what_to_do = "Make a mesh for the collision: `rigor mesh-check FILE --reduce 2000 -o OUT` "
                    "or `--convex-hull`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_collision_is_visual
