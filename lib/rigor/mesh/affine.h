// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Affine maps of space, as the nodes of a scene have them.
//
//   Affine X_WN = X_WP * X_PN;
//   Vector3 p_W = moved(X_WN, p_N);

#pragma once

#include <rigor/model/pose.h>

namespace rigor::mesh {

/// p ↦ x·p.x + y·p.y + z·p.z + origin.
struct Affine {
  model::Vector3 x{1, 0, 0};
  model::Vector3 y{0, 1, 0};
  model::Vector3 z{0, 0, 1};
  model::Vector3 origin;
};

/// Where a direction goes: the origin is left out.
inline model::Vector3 turned(const Affine& by, const model::Vector3& v) {
  return {by.x.x * v.x + by.y.x * v.y + by.z.x * v.z, by.x.y * v.x + by.y.y * v.y + by.z.y * v.z,
          by.x.z * v.x + by.y.z * v.y + by.z.z * v.z};
}

inline model::Vector3 moved(const Affine& by, const model::Vector3& p) {
  return turned(by, p) + by.origin;
}

/// `b` first, then `a`.
inline Affine operator*(const Affine& a, const Affine& b) {
  return {turned(a, b.x), turned(a, b.y), turned(a, b.z), moved(a, b.origin)};
}

/// The volume that a unit cube becomes; negative when it is mirrored.
inline double determinant(const Affine& a) { return dot(cross(a.x, a.y), a.z); }

}  // namespace rigor::mesh
