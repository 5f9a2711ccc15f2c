// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Convex shapes where they stand, and how deep two of them are in each other. The measure is the
// largest ball that fits into both: shapes that touch, or share a sliver, have none worth naming.
//
//   auto a = ConvexShape::of(one.geometry.shape, X_WA);
//   auto b = ConvexShape::of(other.geometry.shape, X_WB);
//   if (a && b && common_ball(*a, *b) > 0.002) say_they_overlap();
//
// Algorithm: E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A fast procedure for computing the distance
// between complex objects in three-dimensional space", IEEE J. Robotics and Automation 4(2), 1988.

#pragma once

#include <cstdint>
#include <optional>

#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/geometry.h>
#include <rigor/model/pose.h>

namespace rigor::mass {

class ConvexShape {
 public:
  /// `X_WS` is the pose of the shape in the frame of the results. Nothing for what has no closed form
  /// (a mesh, a plane, a heightmap, an outline), or when a size is not positive and finite.
  static std::optional<ConvexShape> of(const model::Shape& shape, const model::Pose& X_WS);

  /// The point of the shape that is farthest along a direction, which need not be a unit vector.
  model::Vector3 farthest(const model::Vector3& direction_W) const;

  /// The box around it, along the axes of W.
  mesh::Bounds bounds() const;

  /// Radius of the largest ball inside, m.
  double inradius() const { return inradius_; }

  /// A part of it that keeps `depth` (m) from its surface; exactly all of that part for a box, ball,
  /// cylinder and capsule. `depth` is less than `inradius()`.
  ConvexShape shrunk(double depth) const;

  model::Vector3 center() const { return X_WS_.translation; }

 private:
  enum class Kind : std::uint8_t { kBox, kBall, kCylinder, kCapsule, kCone, kEllipsoid };

  ConvexShape() = default;
  model::Vector3 farthest_in_shape(const model::Vector3& d) const;

  Kind kind_ = Kind::kBall;
  model::Pose X_WS_;
  /// Of a box half its sides, of an ellipsoid its radii; else radius, radius, half the length.
  model::Vector3 half_;
  double inradius_ = 0;
};

/// Whether they have a point in common; of shapes that just touch, either answer.
bool share_a_point(const ConvexShape& a, const ConvexShape& b);

/// Diameter of the largest ball in both (m), to about 1 % of the smaller shape; zero when they are
/// apart. Less than what is true, and more so where one is a cone or an ellipsoid.
double common_ball(const ConvexShape& a, const ConvexShape& b);

/// The same to 0.01 % of the smaller shape, for people to read; `rough` is what `common_ball` says.
double refined_common_ball(const ConvexShape& a, const ConvexShape& b, double rough);

}  // namespace rigor::mass
