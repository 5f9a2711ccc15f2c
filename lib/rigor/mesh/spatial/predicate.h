// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// On which side a place lies, and whether triangles meet, without any rounding in the answer.
//
// Each question comes down to the sign of a determinant of coordinates. It is worked out in doubles
// first; only where their rounding could have turned the sign, once more exactly. (Filter and exact
// sums: J. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates", 1997. Triangles by the signs of their corners: T. Möller, "A fast triangle-triangle
// intersection test", 1997; P. Guigue, O. Devillers, "Fast and robust triangle-triangle overlap test
// using orientation predicates", 2003.)
//
//   if (exactly_seen(p) && side(f, p) == 0) in_the_plane();
//   if (meet(f, g)) touching_or_crossing();

#pragma once

#include <array>
#include <cmath>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Coordinates are 0 or between these in size: then no product of three of them, nor of any of their
/// digits, leaves a double's range, and the answers are exact (2^-300 has digits down to 2^-352, three
/// of which make 2^-1056; a double ends at 2^-1074).
inline constexpr double kMinSeen = 0x1p-300;
inline constexpr double kMaxSeen = 0x1p300;

inline bool exactly_seen(double x) {
  return x == 0 || (std::abs(x) >= kMinSeen && std::abs(x) <= kMaxSeen);
}

inline bool exactly_seen(const Vector3& p) {
  return exactly_seen(p.x) && exactly_seen(p.y) && exactly_seen(p.z);
}

/// What is seen along z, x or y: a place in a coordinate plane.
using Flat = std::array<double, 2>;

using Segment = std::array<Vector3, 2>;

/// The sign, -1, 0 or 1, of det[b - a, c - a, p - a]: 1 where a, b and c are counter-clockwise seen
/// from p.
int side(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& p);
inline int side(const Facet& f, const Vector3& p) { return side(f[0], f[1], f[2], p); }

/// The sign of det[b - a, c - a]: 1 where a, b, c turn to the left.
int turn(const Flat& a, const Flat& b, const Flat& c);

/// The axis, 0 to 2, along which the triangle is seen with an area; 3 when its corners are on a line.
int axis_of_view(const Facet& f);

/// p without its coordinate along `axis`, so that a right-handed frame stays one.
inline Flat seen_along(int axis, const Vector3& p) {
  if (axis == 0) return {p.y, p.z};
  return axis == 1 ? Flat{p.z, p.x} : Flat{p.x, p.y};
}

/// Whether they have any place in common; ends, edges and corners belong to them. Triangles must have
/// an area.
bool meet(const Facet& f, const Facet& g);
bool meet(const Segment& s, const Facet& f);

}  // namespace rigor::mesh
