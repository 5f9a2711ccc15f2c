// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The polygon that points of contact span on level ground, and how far a point is inside it: a body
// that rests on these contacts stands while its center of mass is above the polygon.
//
//   SupportPolygon polygon(contacts);
//   if (polygon.margin({com.x, com.y}) < 0) say_it_tips();
//
// Algorithm: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979
// (monotone chain).

#pragma once

#include <vector>

namespace rigor::mass {

/// In the plane of the ground, m.
struct GroundPoint {
  double x = 0;
  double y = 0;

  bool operator==(const GroundPoint&) const = default;
};

class SupportPolygon {
 public:
  /// Points that are not finite are left out.
  explicit SupportPolygon(std::vector<GroundPoint> contacts);

  /// Counter-clockwise, the leftmost first (of these the lowest); none lies on a side. Two for contacts
  /// on one line, one for a single place.
  const std::vector<GroundPoint>& corners() const { return corners_; }

  /// Distance to the nearest side, m: positive inside, negative outside, and never positive with fewer
  /// than three corners. -infinity without contacts.
  double margin(const GroundPoint& point) const;

 private:
  std::vector<GroundPoint> corners_;
};

}  // namespace rigor::mass
