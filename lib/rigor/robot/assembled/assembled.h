// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A model as it stands assembled: each link's collisions and visuals as boxes where they are, what carries
// what, and how far the parts are apart. For whoever has to look at the robot and not at a value.
//
//   const Assembled robot = assemble(root, frames, bounds_of_mesh);
//   const double gap = robot.gap(robot.subtree(child));   // between the arm and the rest of the robot
//
// All poses are those of `frames`, in its frame W; lengths in meters. A mesh is the box around it; one
// whose bounds are unknown has no box, is counted, and makes its link incomplete.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/robot/assembled/oriented_box.h>
#include <rigor/robot/assembled/twins.h>

namespace rigor::robot {

enum class ShapeRole : std::uint8_t { kCollision, kVisual };

/// The box around a mesh in its own frame, not scaled; nothing when it cannot be read.
using FindBounds = std::function<std::optional<mesh::Bounds>(const model::Mesh&, ShapeRole)>;

/// A collision or a visual.
struct AssembledShape {
  ShapeRole role{};
  std::uint32_t index = 0;  ///< in the root's collisions or visuals
  std::uint32_t link = 0;   ///< in the root's links
  mesh::Bounds bounds_S;    ///< in the shape's own frame, scaled
  model::Pose X_LS;         ///< in the frame of the link
  mesh::Bounds bounds_L;    ///< around it, in the frame of the link
  OrientedBox box_W;
  double radius = 0;  ///< m, of the ball around the box
};

struct AssembledLink {
  model::Id<model::Model> top;               ///< the outermost model that holds it
  std::optional<model::Pose> X_WL;           ///< nothing where the file leaves it open
  std::vector<std::uint32_t> shapes;         ///< collisions, then visuals
  std::size_t unknown = 0;                   ///< shapes without a box
  model::Id<model::Joint> carrier;           ///< the first joint whose child it is; none for a root
  std::vector<std::uint32_t> links_carried;  ///< the children of its joints

  bool complete() const { return unknown == 0; }
};

/// Links by their index in the root.
using Links = std::vector<std::uint32_t>;

struct Assembled {
  std::vector<AssembledShape> shapes;
  std::vector<AssembledLink> links;  ///< by their index in the root
  std::size_t unknown = 0;           ///< shapes without a box, of all links
  /// Left and right by name, of the same model and of the file itself: indices in the root's links and joints.
  std::vector<Twins> link_twins;
  std::vector<Twins> joint_twins;

  /// The link and all that it carries, once each.
  Links subtree(std::uint32_t link) const;

  /// The box around the shapes of a link in its own frame; nothing without such.
  std::optional<mesh::Bounds> bounds(std::uint32_t link, ShapeRole role) const;
  /// In W, around the shapes of all these links.
  std::optional<mesh::Bounds> bounds_W(const Links& of) const;

  /// The longest diagonal of the links, each by itself: a size that no wrong placement changes.
  double longest(const Links& of) const;

  /// Between these links, moved by `d_W`, and all others of the same model; zero where they touch. Nothing
  /// when one side has no shape. Stops at the first pair that is nearer than `enough`.
  std::optional<double> gap(const Links& of, const model::Vector3& d_W = {},
                            double enough = 0) const;
};

Assembled assemble(const model::Root& root, const model::Frames& frames,
                   const FindBounds& find_bounds);

/// Of a shape in its own frame; nothing for what has no end (a plane), no size, or is not known.
std::optional<mesh::Bounds> shape_bounds(const model::Shape& shape, ShapeRole role,
                                         const FindBounds& find_bounds);

}  // namespace rigor::robot
