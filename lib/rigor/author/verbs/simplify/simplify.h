// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes that collide replaced by simpler shapes (mesh/substitute/substitute.h), each within an error bound.
//
//   const Change change = simplified(*edited, {.max_error = 0.02});
//   for (const std::string& note : change.notes) say(note);   // a line for each collision
//
// New meshes lie beside the old ones, as STL in the old file's units, so that a collision keeps its scale and the form
// of its URI. Masses are as they were. Two links that no joint connects and that touch nowhere at rest touch nowhere
// afterwards: where they would, the next shape of the list is taken.

#pragma once

#include <rigor/author/verbs/change.h>

namespace rigor::author {

/// Where a link without a collision gets one from.
enum class MissingCollisions : std::uint8_t { kLeft, kFromVisuals };

struct SimplifyRequest {
  double max_error = 0.02;  ///< of the diagonal of the box around the link's meshes
  MissingCollisions missing = MissingCollisions::kLeft;
};

/// Refused when nothing can be simplified. Left as they are, with a note: collisions in files that are included, those of
/// links whose inertial is computed from them, parts of a mesh, and what no shape fits.
Change simplified(const EditedModel& edited, const SimplifyRequest& request);

}  // namespace rigor::author
