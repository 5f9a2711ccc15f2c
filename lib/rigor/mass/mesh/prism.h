// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The mesh of outlines in the xy plane that are extruded along z. One within another is a hole.
//
//   if (const auto mesh = prism_mesh({plate, bore}, 0.01)) draw(*mesh);

#pragma once

#include <optional>
#include <vector>

#include <rigor/mass/polyline.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mass {

/// Closed, from z = 0 to `height`, m. Nothing where `extruded` finds no solid.
std::optional<mesh::TriangleMesh> prism_mesh(const std::vector<Outline>& outlines, double height);

}  // namespace rigor::mass
