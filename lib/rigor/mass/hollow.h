// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes with a wall instead of a filling: the solid less the smaller solid that the wall leaves free.
//
//   if (auto can = hollow(collision.geometry.shape, 0.002)) use(with_mass(*can, 0.4));
//
// The wall lies inward of the shape's faces; where it meets itself in the middle the shape is solid.
// Differences are never taken of what is nearly equal, so a wall of a millionth of the size is as
// exact as a thick one (see Pair in hollow.cc).

#pragma once

#include <optional>

#include <rigor/mass/shapes.h>

namespace rigor::mass {

/// `wall` in meters, above zero; sizes as in shapes.h. Boxes, cylinders and cones are closed: all their
/// faces have the wall.
Solid hollow_box(const model::Vector3& size, double wall);
Solid hollow_sphere(double radius, double wall);
Solid hollow_cylinder(double radius, double length, double wall);
Solid hollow_capsule(double radius, double length, double wall);
Solid hollow_cone(double radius, double length, double wall);
/// The inner ellipsoid has semi-axes shorter by `wall`: that thick is the wall at the six poles; between
/// them it is thinner, by 2√(ac)/(a + c) at most, a being the longest semi-axis and c the shortest.
Solid hollow_ellipsoid(const model::Vector3& radii, double wall);

/// Nothing for a shape that is none of these, or when a size or the wall is not positive and finite.
std::optional<Solid> hollow(const model::Shape& shape, double wall);

}  // namespace rigor::mass
