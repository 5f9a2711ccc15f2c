// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/outlines.h>

#include <cmath>
#include <cstddef>

#include <rigor/read/documents.h>
#include <rigor/schema/value.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/document.h>

namespace rigor::convert {

using mass::Outline;
using model::Vector3;

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

std::string why_no_prism(const std::vector<Outline>& outlines, double height) {
  if (mass::extruded(outlines, height)) return {};
  if (!(height > 0) || !std::isfinite(height)) {
    return "its height " + schema::to_shortest(height) + " m is not positive and finite";
  }
  std::size_t sides = 0;
  for (const Outline& outline : outlines) {
    const std::size_t corners = mass::corners_of(outline).size();
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
