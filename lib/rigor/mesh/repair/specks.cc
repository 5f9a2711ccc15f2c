// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/repair/specks.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <rigor/mesh/select.h>
#include <rigor/mesh/topology/component.h>
#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/weld.h>

namespace rigor::mesh {

std::uint64_t drop_specks(TriangleMesh& mesh, double share) {
  DefectTally tally;
  const Weld welded = weld(mesh.positions);
  Rings rings = look_round(mesh, welded, tally);
  const Components components = components_of(mesh, welded, rings);
  // With all positions in use, their box is that of the triangles.
  const double limit = share * diagonal(bounds_of(mesh.positions));
  const auto is_speck = [&](const Component& c) { return diagonal(c.bounds) < limit; };
  const auto specks = std::count_if(components.list.begin(), components.list.end(), is_speck);
  if (specks == 0 || specks == std::ssize(components.list)) return 0;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    const std::uint32_t component = components.of_face[face];
    if (component == kNoComponent || !is_speck(components.list[component])) kept.push_back(face);
  }
  mesh = selected(std::move(mesh), kept);
  compact(mesh);
  return static_cast<std::uint64_t>(specks);
}

}  // namespace rigor::mesh
