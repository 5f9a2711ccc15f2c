// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The mesh of SDF's polylines: outlines in the xy plane, extruded along z. One within another is a hole.
// Private to the room.
//
//   const auto outlines = outlines_of(draft.source, visual.geometry);
//   if (auto mesh = prism_mesh(outlines, polyline.height.value)) …

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/mass/polyline.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/geometry.h>

namespace rigor::convert {

/// Of all polylines in a geometry, of which the model keeps the first.
std::vector<mass::Outline> outlines_of(const Source& source, const model::Geometry& geometry);

/// Closed, from z = 0 to `height`. Nothing when the outlines enclose no solid (mass::extruded).
std::optional<mesh::TriangleMesh> prism_mesh(const std::vector<mass::Outline>& outlines,
                                             double height);

/// Why that is nothing; empty where it is a mesh.
std::string why_no_prism(const std::vector<mass::Outline>& outlines, double height);

}  // namespace rigor::convert
