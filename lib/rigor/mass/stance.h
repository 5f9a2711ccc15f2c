// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a robot that stands on level ground stays up: its lowest points, and how far its center of
// mass is inside the polygon that they span.
//
//   if (auto stance = stance_of(root, frames, model, find_mesh, com)) say(stance->margin);

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <rigor/mass/link_body.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::mass {

/// Points within this height of the lowest touch the ground too: what a caster or wheel that is off by
/// a rounding of its numbers still does.
inline constexpr double kTouching = 2e-3;  // m

struct Stance {
  std::size_t points = 0;  ///< corners of the support polygon; fewer than three support nothing
  double height = 0;       ///< m, of the lowest point
  /// m, from the vertical through the center of mass to the polygon's nearest edge; negative outside.
  /// Nothing without a polygon.
  std::optional<double> margin;
};

/// `com` in the frame of the poses, whose z is up. Nothing when the model has no collision with a
/// place, or a joint holds it to the world. A mesh is taken for the box around it.
std::optional<Stance> stance_of(const model::Root& root, const model::Frames& frames,
                                model::Id<model::Model> model, const FindMesh& find_mesh,
                                const model::Vector3& com);

}  // namespace rigor::mass
