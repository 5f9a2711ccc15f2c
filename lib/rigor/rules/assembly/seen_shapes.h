// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The collisions and visuals of a link beside each other, in the frame of the link.

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>
#include <rigor/robot/assembled/assembled.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// A shape of a link with what the file says of it.
struct SeenShape {
  const robot::AssembledShape* shape = nullptr;
  const model::Geometry* geometry = nullptr;
  const model::PoseField* pose = nullptr;
  mesh::Bounds bounds_L;  ///< in the frame of the link

  bool is_collision() const { return shape->role == robot::ShapeRole::kCollision; }
};

inline std::vector<SeenShape> seen_shapes(std::uint32_t link, Context& context) {
  const model::Root& root = context.root();
  const robot::Assembled& robot = context.assembled();
  std::vector<SeenShape> result;
  result.reserve(robot.links[link].shapes.size());
  for (const std::uint32_t s : robot.links[link].shapes) {
    const robot::AssembledShape& shape = robot.shapes[s];
    SeenShape seen{&shape, nullptr, nullptr, shape.bounds_L};
    if (seen.is_collision()) {
      seen.geometry = &root.collisions[shape.index].geometry;
      seen.pose = &root.collisions[shape.index].pose;
    } else {
      seen.geometry = &root.visuals[shape.index].geometry;
      seen.pose = &root.visuals[shape.index].pose;
    }
    result.push_back(seen);
  }
  return result;
}

inline std::string subject_of_shape(const SeenShape& seen, const Context& context) {
  const model::Root& root = context.root();
  return seen.is_collision() ? context.subject(root.collisions[seen.shape->index])
                             : context.subject(root.visuals[seen.shape->index]);
}

inline const char* role_name(const SeenShape& seen) {
  return seen.is_collision() ? "collision" : "visual";
}

/// m, the sides of a box.
inline model::Vector3 sides(const mesh::Bounds& box) { return box.max - box.min; }

/// The bounds moved by d.
inline mesh::Bounds moved_by(const mesh::Bounds& box, const model::Vector3& d) {
  return {box.min + d, box.max + d};
}

/// How alike two boxes are when one is put upon the other: 1 when their sides are equal.
inline double size_likeness(const mesh::Bounds& a, const mesh::Bounds& b) {
  const auto centered = [](const mesh::Bounds& box) {
    return moved_by(box, -0.5 * (box.min + box.max));
  };
  return robot::likeness(centered(a), centered(b));
}

}  // namespace rigor::rules
