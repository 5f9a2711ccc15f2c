// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/prism.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <rigor/mesh/repair/cap.h>
#include <rigor/read/documents.h>
#include <rigor/schema/value.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/document.h>

namespace rigor::convert {
namespace {

using mass::Outline;
using mesh::TriangleMesh;
using model::Vector3;

/// Twice the area that an outline goes round, m²; negative when it goes clockwise.
double doubled_area(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    sum += cross(outline[i] - outline[0], outline[i + 1] - outline[0]).z;
  }
  return sum;
}

/// By the number of sides that a ray along x crosses.
bool goes_round(const Outline& outline, const Vector3& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector3& a = outline[i];
    const Vector3& b = outline[(i + 1) % outline.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) inside = !inside;
  }
  return inside;
}

/// Without corners that repeat the one before.
Outline corners_of(const Outline& outline) {
  Outline kept;
  for (const Vector3& p : outline) {
    if (kept.empty() || p != kept.back()) kept.push_back(p);
  }
  while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  return kept;
}

/// Counterclockwise, and holes clockwise, so that what is solid is on the left.
std::vector<Outline> with_solid_on_left(const std::vector<Outline>& outlines) {
  std::vector<Outline> all;
  for (const Outline& outline : outlines) all.push_back(corners_of(outline));
  std::vector<Outline> result = all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    bool is_hole = false;
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (j != i && goes_round(all[j], all[i].front())) is_hole = !is_hole;
    }
    if (is_hole == (doubled_area(all[i]) > 0)) std::reverse(result[i].begin(), result[i].end());
  }
  return result;
}

}  // namespace

std::vector<Outline> outlines_of(const Source& source, const model::Geometry& geometry) {
  std::vector<Outline> outlines;
  const auto parent = source.documents.element(geometry.site).parent();
  if (!parent) return outlines;
  for (const xml::Element polyline : parent->children()) {
    if (polyline.name() != "polyline") continue;
    Outline& outline = outlines.emplace_back();
    for (const xml::Element point : polyline.children()) {
      if (point.name() != "point") continue;
      const auto xy = write::numbers_in(point.text());
      outline.push_back(xy && xy->size() == 2 ? Vector3{(*xy)[0], (*xy)[1], 0} : Vector3{});
    }
  }
  return outlines;
}

std::optional<TriangleMesh> prism_mesh(const std::vector<Outline>& outlines, double height) {
  if (!mass::extruded(outlines, height)) return std::nullopt;
  TriangleMesh prism;
  std::vector<mesh::DirectedEdge> edges;
  for (const Outline& outline : with_solid_on_left(outlines)) {
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

std::string why_no_prism(const std::vector<Outline>& outlines, double height) {
  if (mass::extruded(outlines, height)) return {};
  if (!(height > 0) || !std::isfinite(height)) {
    return "its height " + schema::to_shortest(height) + " m is not positive and finite";
  }
  std::size_t sides = 0;
  for (const Outline& outline : outlines) {
    const std::size_t corners = corners_of(outline).size();
    if (corners < 3) return "an outline has " + std::to_string(corners) + " of at least 3 points";
    sides += corners;
  }
  if (sides > mass::kMaxSides) {
    return "its outlines have " + std::to_string(sides) + " sides; the limit is " +
           std::to_string(mass::kMaxSides);
  }
  return "its outlines cross or touch, or enclose no area";
}

}  // namespace rigor::convert
