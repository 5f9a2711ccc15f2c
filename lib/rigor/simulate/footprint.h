// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What something stands on, seen from above, and how far its center of mass is from the edge.
//
//   const std::vector<Vector3> corners = footprint(contacts);
//   if (corners.size() >= 3 && margin_in(corners, com).distance < 0) falls();

#pragma once

#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// Corners of the convex hull of the points' x and y, counter-clockwise; their z are kept. Fewer than
/// three where it has no area: it is no wider than kThinFootprint.
std::vector<Vector3> footprint(std::vector<Vector3> points);

/// Two wheels and nothing else: contacts of one wheel's edge are nearer to each other than this.
inline constexpr double kThinFootprint = 1e-4;  // m

struct FootprintMargin {
  double distance = 0;    ///< m, to the nearest side; negative outside
  double half_width = 0;  ///< m, of the footprint across that side
  Vector3 outward;        ///< level unit vector across that side
};

/// Of at least three corners.
FootprintMargin margin_in(const std::vector<Vector3>& corners, const Vector3& point);

/// Models are drawn this exactly.
inline constexpr double kFootSlack = 0.001;  // m

/// Where a model stands at the start, were level ground under its lowest point: the footprint of all
/// of its points that are not more than `slack` (m) above the lowest.
std::vector<Vector3> footprint_at_start(const Scene& scene, std::uint32_t model, double slack);

/// How far a table may tilt before what stands on these corners (at least three) falls off.
struct TiltOver {
  double angle = 0;  ///< rad; negative where it falls on level ground
  Vector3 outward;   ///< level unit vector: towards the side that it falls over first
};

TiltOver tip_angle(const Scene& scene, std::uint32_t model, const std::vector<Vector3>& corners);

/// Center of mass of what moves of a model at the start, in W.
Vector3 center_of_mass(const Scene& scene, std::uint32_t model);

}  // namespace rigor::simulate
