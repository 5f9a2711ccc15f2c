// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Points and vectors of a plane, for what is flat or examined along a direction.
//
//   if (turn(a, b, c) > 0) left_of_the_line_from_a_to_b(c);

#pragma once

namespace rigor::mesh {

struct PlanePoint {
  double x = 0;
  double y = 0;
};

inline PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) {
  return {a.x - b.x, a.y - b.y};
}
inline double dot(const PlanePoint& a, const PlanePoint& b) { return a.x * b.x + a.y * b.y; }
inline double cross(const PlanePoint& a, const PlanePoint& b) { return a.x * b.y - a.y * b.x; }

/// Twice the area of the triangle: above zero when c is left of the line from a to b.
inline double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return cross(b - a, c - a);
}

}  // namespace rigor::mesh
