// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How much space two shapes share: what a link's mass counts twice.
//
//   double share = overlap({collision.geometry.shape, X_LA}, {other.geometry.shape, X_LB});

#pragma once

#include <rigor/model/geometry.h>
#include <rigor/model/pose.h>

namespace rigor::mass {

struct PlacedShape {
  const model::Shape& shape;
  model::Pose X_LS;  ///< of the shape in the link frame
};

/// The shared volume as a share of the smaller shape's, by points spread evenly over it: good to two
/// digits, and below 0.001 zero. Zero as well for a shape without a closed form (a mesh, a plane).
double overlap(const PlacedShape& a, const PlacedShape& b);

/// Of a ball around the shape's origin that holds it, m; zero for a shape that overlaps none.
double reach_of(const model::Shape& shape);

}  // namespace rigor::mass
