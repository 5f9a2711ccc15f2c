// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh/prism.h>

#include <algorithm>
#include <cstdint>

#include <rigor/mesh/repair/cap.h>

namespace rigor::mass {
namespace {

using mesh::TriangleMesh;
using model::Vector3;

std::vector<Outline> with_solid_on_the_left(const std::vector<Outline>& outlines) {
  std::vector<Outline> directed;
  for (const Outline& outline : outlines) directed.push_back(corners_of(outline));
  const std::vector<bool> turned = with_solid_on_the_right(directed);
  for (std::size_t i = 0; i < directed.size(); ++i) {
    if (turned[i]) std::reverse(directed[i].begin(), directed[i].end());
  }
  return directed;
}

}  // namespace

std::optional<TriangleMesh> prism_mesh(const std::vector<Outline>& outlines, double height) {
  if (!extruded(outlines, height)) return std::nullopt;
  TriangleMesh prism;
  std::vector<mesh::DirectedEdge> edges;
  for (const Outline& outline : with_solid_on_the_left(outlines)) {
    const auto first = static_cast<std::uint32_t>(prism.positions.size());
    const auto count = static_cast<std::uint32_t>(outline.size());
    prism.positions.insert(prism.positions.end(), outline.begin(), outline.end());
    for (std::uint32_t i = 0; i < count; ++i) edges.push_back({first + i, first + (i + 1) % count});
  }
  const auto n = static_cast<std::uint32_t>(prism.positions.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vector3 p = prism.positions[i];
    prism.positions.push_back({p.x, p.y, height});
  }
  for (const auto& [from, to] : edges) {
    prism.triangles.push_back({from, to, n + to});
    prism.triangles.push_back({from, n + to, n + from});
  }
  for (const auto& [a, b, c] : mesh::cap_of(edges, prism.positions, {0, 0, 1})) {
    prism.triangles.push_back({n + a, n + b, n + c});
    prism.triangles.push_back({a, c, b});
  }
  return prism;
}

}  // namespace rigor::mass
