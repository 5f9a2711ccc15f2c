// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// All outlines of SDF's polylines. Private to the room.
//
//   if (auto mesh = mass::prism_mesh(outlines_of(source, visual.geometry), height)) …

#pragma once

#include <string>
#include <vector>

#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/mass/polyline.h>
#include <rigor/model/geometry.h>

namespace rigor::convert {

/// Of all polylines in a geometry, of which the model keeps the first.
std::vector<mass::Outline> outlines_of(const Source& source, const model::Geometry& geometry);

/// Why they are no solid of that height (mass::extruded); empty where they are one.
std::string why_no_prism(const std::vector<mass::Outline>& outlines, double height);

}  // namespace rigor::convert
