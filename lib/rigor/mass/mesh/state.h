// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a mesh is good for as a body (survey.h decides it).

#pragma once

#include <cstdint>

namespace rigor::mass {

/// What a mesh is good for.
enum class MeshState : std::uint8_t {
  kSolid,        ///< closed, wound outward, and counts every place once
  kInverted,     ///< closed, but wound inside out
  kOpen,         ///< not closed
  kOverlapping,  ///< closed, but counts more than kMaxDoubled (survey.h) of its inside twice
  kMixed,        ///< closed, but more than kMaxDoubled of it is inside out, and not all
  kFlat,         ///< encloses nothing
  kUnusable,     ///< could not be read
};

/// Where the body comes from.
enum class BodyFrom : std::uint8_t { kMesh, kTurnedMesh, kHull };

}  // namespace rigor::mass
