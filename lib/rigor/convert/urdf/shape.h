// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SDF's shapes as URDF's: as they are where URDF has them, as an exact union where it has not, as a mesh
// file where that is asked for. Private to the room.
//
//   for (const UrdfShape& shape : urdf_shapes(draft, visual.geometry, subject)) …

#pragma once

#include <string>
#include <vector>

#include <rigor/convert/urdf/draft.h>
#include <rigor/convert/urdf/robot.h>
#include <rigor/model/geometry.h>
#include <rigor/model/pose.h>

namespace rigor::convert {

struct UrdfShape {
  UrdfGeometry geometry;
  model::Pose X_VS;    ///< of this part in the collision or visual
  std::string suffix;  ///< to the name of the collision or visual
};

/// Nothing when URDF has no such shape; then nothing was taken, and nothing noted but the URI.
///
/// A part of a mesh file (`<submesh>`) is none, either, unless files may be written: the whole file
/// in its place would show, or collide with, what the model never had.
std::vector<UrdfShape> urdf_shapes(UrdfDraft& draft, const model::Geometry& geometry,
                                   const std::string& subject);

}  // namespace rigor::convert
