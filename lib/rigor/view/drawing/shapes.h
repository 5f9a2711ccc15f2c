// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes as triangles. Boxes, balls, cylinders, cones and ellipsoids of all sizes share one mesh each, of size
// one, which a body scales. Private to the room.
//
//   ShapeMeshes shapes;
//   const ShapeMesh ball = shapes.of(model::Sphere{.radius = {0.1}});
//   if (ball.mesh) place(*ball.mesh, ball.scale); else say(ball.why);

#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <rigor/mass/polyline.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/geometry.h>
#include <rigor/view/image/picture.h>

namespace rigor::view {

struct ShapeMesh {
  std::shared_ptr<const mesh::TriangleMesh> mesh;  ///< null when there is none
  model::Vector3 scale{1, 1, 1};
  std::string why = {};  ///< there is none
};

class ShapeMeshes {
 public:
  /// Of a primitive. Those that need more than their own numbers (planes, meshes, heightmaps, polylines)
  /// have none here.
  ShapeMesh of(const model::Shape& shape);

  /// A square of side one in the plane z = 0, seen from above.
  std::shared_ptr<const mesh::TriangleMesh> square();

 private:
  enum class Unit { kBox, kBall, kCylinder, kCone, kSquare };
  friend struct ShapeMeshVisitor;

  std::shared_ptr<const mesh::TriangleMesh> unit(Unit which);
  ShapeMesh capsule(double radius, double length);

  std::map<Unit, std::shared_ptr<const mesh::TriangleMesh>> units_;
  std::map<double, std::shared_ptr<const mesh::TriangleMesh>>
      capsules_;  // of radius one, by length
};

/// Capsules of more different proportions are not drawn: each has a mesh of its own, of 4,000 triangles.
inline constexpr std::size_t kMaxCapsules = 1000;

/// A heightmap is drawn with so many points along a side: 500,000 triangles. Terrains have up to 2,049.
inline constexpr std::size_t kMaxHeights = 513;

/// The picture's rows from +y to -y, its columns from -x to x; the brightest pixel is as high as `size.z`,
/// black is zero.
std::shared_ptr<const mesh::TriangleMesh> terrain_mesh(const Picture& heights,
                                                       const model::Vector3& size);

}  // namespace rigor::view
