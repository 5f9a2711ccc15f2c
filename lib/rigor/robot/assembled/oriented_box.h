// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Boxes with axes of their own, and how far apart two of them are.
//
//   const OrientedBox box = box_around(bounds_S, X_WS);
//   if (separation(box, other) > 0) say_they_are_apart();
//
// Algorithm: the separating axis theorem (S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: a hierarchical
// structure for rapid interference detection", SIGGRAPH 1996).

#pragma once

#include <array>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/pose.h>

namespace rigor::robot {

struct OrientedBox {
  model::Vector3 center_W;               ///< m
  std::array<model::Vector3, 3> axes_W;  ///< unit vectors
  std::array<double, 3> half{};          ///< m, half of the sides along the axes
};

/// The box around what lies within `bounds_S`.
OrientedBox box_around(const mesh::Bounds& bounds_S, const model::Pose& X_WS);

/// The box moved by `d_W`, m.
OrientedBox moved(OrientedBox box, const model::Vector3& d_W);

/// The widest gap between their shadows on an axis, m: never more than their distance, and at least half
/// of it. Negative when they overlap: how far one has to be moved until they do not.
double separation(const OrientedBox& a, const OrientedBox& b);

/// From a point to the box, m; zero inside.
double distance(const OrientedBox& box, const model::Vector3& p_W);

bool contains(const OrientedBox& box, const model::Vector3& p_W);

/// How much of a box is inside any of the others: 0 to 1, by the middles of 64 equal parts of it.
double share_inside(const OrientedBox& box, const std::vector<OrientedBox>& others);

/// Diameter of the ball around it, m.
double diameter(const OrientedBox& box);

/// The bounds along the axes of W.
mesh::Bounds bounds_of(const OrientedBox& box);

/// Of the bounds that hold both.
mesh::Bounds joined(const mesh::Bounds& a, const mesh::Bounds& b);

/// What two bounds share, as a share of the smaller one (`cover`) or of what both fill (`likeness`): 0 to
/// 1. What is thinner than a millimeter counts as one millimeter.
double cover(const mesh::Bounds& a, const mesh::Bounds& b);
double likeness(const mesh::Bounds& a, const mesh::Bounds& b);

}  // namespace rigor::robot
