// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Closed forms: volume, center of mass and inertia of solid shapes of even density.
//
//   if (auto solid = solid_of(collision.geometry.shape)) {
//     Inertia inertia = mass * solid->unit_inertia;   // kg·m² about the shape's center of mass
//   }
//
// Formulas: "CRC Standard Mathematical Tables", 31st ed., 2003, §6 (moments of inertia of uniform
// solids); the capsule is a cylinder and two half balls joined by parallel axes, the center of a half
// ball lying 3r/8 from its flat face.

#pragma once

#include <optional>

#include <rigor/mass/mass_properties.h>
#include <rigor/model/geometry.h>

namespace rigor::mass {

/// A solid, in the frame of its shape (see model/geometry.h).
struct Solid {
  double volume = 0;     ///< m³
  model::Vector3 com;    ///< m; off the origin only for a cone
  Inertia unit_inertia;  ///< m²: per kilogram, about `com`, along the shape's axes
};

/// Full side lengths, m.
Solid box(const model::Vector3& size);
Solid sphere(double radius);
/// `length` along z.
Solid cylinder(double radius, double length);
/// `length` of the cylindrical part, along z: the caps add two radii.
Solid capsule(double radius, double length);
/// Base at z = -length/2, apex at z = +length/2.
Solid cone(double radius, double length);
/// Semi-axes, m.
Solid ellipsoid(const model::Vector3& radii);

/// Nothing for a shape without a closed form (mesh, plane, heightmap, image, none), when a size is
/// not positive and finite, or for an outline that encloses nothing (polyline.h).
std::optional<Solid> solid_of(const model::Shape& shape);

/// The solid with this mass (kg), in the frame of its shape.
MassProperties with_mass(const Solid& solid, double mass);

/// The solid at this density (kg/m³), in the frame of its shape.
MassProperties of_density(const Solid& solid, double density);

}  // namespace rigor::mass
