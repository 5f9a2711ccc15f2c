// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_flat {

// Of the diagonal: what single precision leaves of zero after some arithmetic.
constexpr double kFlat = 1e-6;

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape || shape->topology.vertices < 4) return;  // mesh-too-few-vertices
  const mesh::Bounds& bounds = file.facts.bounds;
  const auto [x, y, z] = bounds.max - bounds.min;
  const double size = mesh::diagonal(bounds);
  if (std::min({x, y, z}) > kFlat * size) return;
  const char axis = x <= kFlat * size ? 'x' : y <= kFlat * size ? 'y' : 'z';
  report_mesh(file, context,
              fmt::format("the mesh has no thickness along {}, so that it encloses nothing", axis));
}

Rule rule() {
  return {
      .name = "mesh-flat",
      .severity = Severity::kInfo,
      .summary = "a mesh for collisions has no thickness",
      .why = "It encloses nothing: no mass or inertia can be taken from it, and MuJoCo rejects a "
             "mesh without volume, unless it is told to take it for a shell. Drawn, it is fine.",
      .what_to_do = "Use a box, a plane, or give the mesh a thickness.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_flat
