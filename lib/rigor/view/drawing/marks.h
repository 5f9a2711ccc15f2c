// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is drawn of a model besides its shapes, of size one: frames, axes, centers of mass, the ground.
// Private to the room.
//
//   Body body{.mesh = arrows().mesh, .scale = {0.1, 0.1, 0.1}, .surfaces = arrows().surfaces};

#pragma once

#include <memory>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>
#include <rigor/view/drawing/drawing.h>

namespace rigor::view {

struct Mark {
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  std::vector<Surface> surfaces;  ///< one for each part
};

/// Arrows of length one along x (red), y (green) and z (blue).
Mark frame_mark();

/// An arrow of length one along z.
Mark axis_mark();

/// A ball of radius one, its octants black and white by turns.
Mark com_mark();

/// A red ball of radius one.
Mark contact_mark();

/// Lines a step apart (m), in the plane z = 0 around `center`, `cells` steps to each side; the lines lie at
/// multiples of the step.
struct Grid {
  model::Vector3 center;
  double step = 1;
  int cells = 10;
};

/// A grid that a model within `bounds` stands on: a meter apart, or a power of ten of it that suits the model's
/// size. `bounds` may be empty.
Grid grid_under(const mesh::Bounds& bounds);

/// Every place of the square once: parts "plane" and "lines". In the frame of the grid's lines nearest to
/// its center, which `ground_origin` says.
Mark ground_mark(const Grid& grid);
model::Vector3 ground_origin(const Grid& grid);

}  // namespace rigor::view
