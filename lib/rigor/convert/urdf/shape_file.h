// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Mesh files that represent shapes that URDF lacks. Private to the room.
//
//   if (auto name = shape_file(draft, shape)) return UrdfMesh{*name};

#pragma once

#include <optional>
#include <string>

#include <rigor/convert/urdf/draft.h>
#include <rigor/model/geometry.h>

namespace rigor::convert {

/// The name of the draft's file with this shape, which equal ones share: an ellipsoid, a cone, a prism
/// over outlines with their holes, or the part of a mesh file. Nothing for other shapes, and for what has no such
/// mesh: a size that is not positive, an outline that crosses itself, a part that is not there.
std::optional<std::string> shape_file(UrdfDraft& draft, const model::Geometry& geometry);

/// What keeps a shape from having a file, where files may be written: "its height 0 m is not positive".
/// Empty for shapes that never have one.
std::string why_no_shape_file(const UrdfDraft& draft, const model::Geometry& geometry);

}  // namespace rigor::convert
