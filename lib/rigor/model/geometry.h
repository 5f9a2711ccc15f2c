// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The shapes of collisions and visuals. Lengths in meters; each shape is centered at the origin of
// the collision or visual that holds it, its length along z.

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rigor/model/field.h>
#include <rigor/model/pose.h>
#include <rigor/model/site.h>

namespace rigor::model {

struct Box {
  Field<Vector3> size;  ///< full side lengths
};

struct Sphere {
  Field<double> radius;
};

struct Cylinder {
  Field<double> radius;
  Field<double> length;
};

struct Capsule {
  Field<double> radius;
  Field<double> length;  ///< of the cylindrical part: the caps add two radii
};

/// Base at z = -length/2, apex at z = +length/2.
struct Cone {
  Field<double> radius;
  Field<double> length;
};

struct Ellipsoid {
  Field<Vector3> radii;
};

struct Plane {
  Field<Vector3> normal;
};

struct Mesh {
  Field<std::string> uri;  ///< as written: `model://`, `package://`, `file://` or relative
  Field<Vector3> scale;
  Field<std::string> submesh;
  Field<bool> center;  ///< the submesh is moved so that the middle of its bounds is the origin
  /// MJCF: vertices that the model's own file gives, before `scale`; then there is no `uri`. Without
  /// faces the mesh is their convex hull.
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
  bool sheet = false;  ///< MJCF: `inertia="shell"`: it weighs as its surface
};

struct Heightmap {
  Field<std::string> uri;
  Field<Vector3> size;
};

struct Image {
  Field<std::string> uri;
};

/// A closed outline in the xy plane, extruded from z = 0 to `height`.
struct Polyline {
  std::vector<Field<Vector3>> points;  ///< z is zero
  Field<double> height;
};

/// No shape element, or one that no version knows.
struct NoShape {};

using Shape = std::variant<NoShape, Box, Sphere, Cylinder, Capsule, Cone, Ellipsoid, Plane, Mesh,
                           Heightmap, Image, Polyline>;

struct Geometry {
  Site site;             ///< of the shape's element; of `<geometry>` when there is none
  bool written = false;  ///< whether there is a `<geometry>` element
  Shape shape;
  /// Further shape elements in the same geometry: a consumer takes one and drops the rest.
  std::vector<Site> more;
  /// The first element in a geometry in which none is a shape.
  Site no_shape;
  bool explicitly_empty = false;  ///< SDF's `<empty/>`
};

/// The element's name in SDF: "box"; "none" for `NoShape`.
std::string_view shape_name(const Shape& shape);

}  // namespace rigor::model
