// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/fitted_primitive.h>

#include <algorithm>

namespace rigor::mass {

using model::Vector3;

FittedPrimitive fitted_primitive(const Solid& mesh, model::GeomWeight::Fit fit, double scale) {
  const PrincipalAxes principal = principal_axes(mesh.unit_inertia);
  const auto sides = equivalent_box(1, principal.moments);
  // A body is longest where its moment is least.
  const Vector3 h = scale / 2 * Vector3{sides[2], sides[1], sides[0]};
  const Vector3 z = principal.axes[0], y = principal.axes[1], x = cross(y, z);
  FittedPrimitive fitted;
  fitted.X_MS = {mesh.com, model::from_axes(x, y, z)};
  const double radius = (h.x + h.y) / 2;
  using Fit = model::GeomWeight::Fit;
  switch (fit) {
    case Fit::kNone: break;
    case Fit::kSphere: fitted.shape = model::Sphere{{(h.x + h.y + h.z) / 3}}; break;
    case Fit::kCapsule:
      fitted.shape = model::Capsule{{radius}, {2 * std::max(0.0, h.z - radius / 2)}};
      break;
    case Fit::kCylinder: fitted.shape = model::Cylinder{{radius}, {2 * h.z}}; break;
    case Fit::kEllipsoid: fitted.shape = model::Ellipsoid{{h}}; break;
    case Fit::kBox: fitted.shape = model::Box{{2 * h}}; break;
  }
  return fitted;
}

}  // namespace rigor::mass
