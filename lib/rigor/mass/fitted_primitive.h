// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The primitive that MuJoCo puts in place of a mesh where a geom of another type names one.
//
//   const FittedPrimitive fitted = fitted_primitive(solid, GeomWeight::Fit::kCapsule, 1);
//
// Of the half sides h of the box with the mesh's moments (equivalent_box), ascending: a sphere of their mean; a cylinder
// along the longest, of radius (h1 + h2)/2 and half length h3; a capsule of the same radius r, whose cylinder has the
// half length h3 - r/2; an ellipsoid and a box of h (MuJoCo's documentation, XML reference, "compiler/fitaabb"; the
// capsule as its compiler has it).

#pragma once

#include <rigor/mass/shapes.h>
#include <rigor/model/model.h>
#include <rigor/model/pose.h>

namespace rigor::mass {

struct FittedPrimitive {
  model::Shape shape;
  model::Pose X_MS;  ///< in the mesh's frame
};

/// `fit` is not kNone; sizes are multiplied by `scale`.
FittedPrimitive fitted_primitive(const Solid& mesh, model::GeomWeight::Fit fit, double scale);

}  // namespace rigor::mass
