// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <rigor/mesh/repair/cap.h>
#include <rigor/view/drawing/shapes.h>

namespace rigor::view {
namespace {

using mass::Outline;
using mesh::TriangleMesh;
using model::Vector3;

/// Twice the area, negative for a clockwise outline; as seen from its first corner.
double signed_area(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    sum += cross(outline[i] - outline[0], outline[i + 1] - outline[0]).z;
  }
  return sum;
}

/// By the number of sides that a ray along x crosses.
bool surrounds(const Outline& outline, const Vector3& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector3& a = outline[i];
    const Vector3& b = outline[(i + 1) % outline.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) inside = !inside;
  }
  return inside;
}

Outline without_repeats(const Outline& outline) {
  Outline kept;
  for (const Vector3& p : outline) {
    const Vector3 flat{p.x, p.y, 0};
    if (kept.empty() || flat != kept.back()) kept.push_back(flat);
  }
  while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  return kept;
}

/// Solids against the clock and holes with it, so that what is solid is on their left.
std::vector<Outline> directed_outlines(const std::vector<Outline>& outlines) {
  std::vector<Outline> directed;
  for (const Outline& outline : outlines) directed.push_back(without_repeats(outline));
  std::vector<bool> turn(directed.size());
  for (std::size_t i = 0; i < directed.size(); ++i) {
    bool hole = false;
    for (std::size_t j = 0; j < directed.size(); ++j) {
      if (j != i && surrounds(directed[j], directed[i].front())) hole = !hole;
    }
    turn[i] = hole == (signed_area(directed[i]) > 0);
  }
  for (std::size_t i = 0; i < directed.size(); ++i) {
    if (turn[i]) std::reverse(directed[i].begin(), directed[i].end());
  }
  return directed;
}

}  // namespace

std::shared_ptr<const TriangleMesh> extruded_mesh(const std::vector<Outline>& outlines,
                                                  double height) {
  if (!mass::extruded(outlines, height)) return nullptr;
  TriangleMesh mesh;
  std::vector<mesh::DirectedEdge> edges;
  for (const Outline& outline : directed_outlines(outlines)) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto count = static_cast<std::uint32_t>(outline.size());
    mesh.positions.insert(mesh.positions.end(), outline.begin(), outline.end());
    for (std::uint32_t i = 0; i < count; ++i) edges.push_back({first + i, first + (i + 1) % count});
  }
  const auto above = static_cast<std::uint32_t>(mesh.positions.size());
  for (const mesh::Triangle& t : mesh::cap_of(edges, mesh.positions, {0, 0, 1})) {
    mesh.triangles.push_back({t[0] + above, t[1] + above, t[2] + above});
    mesh.triangles.push_back({t[0], t[2], t[1]});
  }
  for (const auto& [a, b] : edges) {
    mesh.triangles.push_back({a, b, b + above});
    mesh.triangles.push_back({a, b + above, a + above});
  }
  for (std::uint32_t i = 0; i < above; ++i) {
    const Vector3 p = mesh.positions[i];
    mesh.positions.push_back({p.x, p.y, height});
  }
  mesh.parts = {{"polyline", {}, 0, mesh.triangles.size()}};
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

std::shared_ptr<const TriangleMesh> terrain_mesh(const Picture& heights, const Vector3& size) {
  const bool whole = heights.width > 1 && heights.height > 1 &&
                     heights.pixels.size() == std::size_t{heights.width} * heights.height;
  if (!whole || !(size.x > 0) || !(size.y > 0) || !std::isfinite(size.x + size.y + size.z)) {
    return nullptr;
  }
  const auto columns =
      static_cast<std::uint32_t>(std::min<std::size_t>(heights.width, kMaxHeights));
  const auto rows = static_cast<std::uint32_t>(std::min<std::size_t>(heights.height, kMaxHeights));
  const auto brightness = [&](std::uint32_t x, std::uint32_t y) { return heights.at(x, y)[0]; };
  std::uint8_t brightest = 0;
  for (const Pixel& pixel : heights.pixels) brightest = std::max(brightest, pixel[0]);
  const double scale = brightest > 0 ? std::abs(size.z) / brightest : 0;
  TriangleMesh mesh;
  for (std::uint32_t row = 0; row < rows; ++row) {
    const double down = double(row) / (rows - 1);
    const auto y = static_cast<std::uint32_t>(std::lround(down * (heights.height - 1)));
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double right = double(column) / (columns - 1);
      const auto x = static_cast<std::uint32_t>(std::lround(right * (heights.width - 1)));
      mesh.positions.push_back(
          {(right - 0.5) * size.x, (0.5 - down) * size.y, scale * brightness(x, y)});
    }
  }
  for (std::uint32_t row = 0; row + 1 < rows; ++row) {
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
      const std::uint32_t a = row * columns + column;
      const std::uint32_t below = a + columns;
      mesh.triangles.push_back({below, below + 1, a + 1});
      mesh.triangles.push_back({below, a + 1, a});
    }
  }
  mesh.parts = {{"heightmap", {}, 0, mesh.triangles.size()}};
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

}  // namespace rigor::view
