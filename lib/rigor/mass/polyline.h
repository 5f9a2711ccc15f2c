// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Solids that are closed outlines in the xy plane, extruded along z: SDF's `<polyline>`.
//
//   if (auto solid = extruded({plate, bore}, 0.01)) use(of_density(*solid, 2700));
//
// Formulas: moments of a polygon as sums over its sides (S. F. Bockman, "Generalizing the formula for
// areas of polygons to moments", American Mathematical Monthly 96, 1989), times the height.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <rigor/mass/shapes.h>
#include <rigor/model/geometry.h>

namespace rigor::mass {

/// Corners in either direction, m; their z does not matter. The first may be repeated at the end.
using Outline = std::vector<model::Vector3>;

/// More sides than this are not examined: whether they cross takes the square of their number in the
/// worst case, here a fifth of a second.
inline constexpr std::size_t kMaxSides = 10'000;

/// From z = 0 to `height`. An outline inside another one is a hole, one inside the hole is solid again.
/// Nothing when sides cross or touch others than their neighbors, when an outline has no area, when a
/// number is not finite or the height not positive, or beyond kMaxSides.
std::optional<Solid> extruded(const std::vector<Outline>& outlines, double height);

std::optional<Solid> solid_of(const model::Polyline& polyline);

/// Without corners that repeat the one before, at z = 0.
Outline corners_of(const Outline& outline);

/// Of outlines of corners that do not touch: whether each goes round clockwise, as the hole in a solid should, or a solid does
/// that should not. With those turned, what is solid is left of every side.
std::vector<bool> with_solid_on_the_right(const std::vector<Outline>& outlines);

}  // namespace rigor::mass
