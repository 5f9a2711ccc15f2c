// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A geom as a shape, with what it weighs and whether it touches and is drawn.

#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>

#include <rigor/model/model.h>
#include <rigor/read/mjcf/mjcf_assets.h>
#include <rigor/read/mjcf/mjcf_defaults.h>
#include <rigor/read/mjcf/mjcf_settings.h>

namespace rigor::read {

/// MuJoCo's viewer draws the groups from 0 to 2; models keep visuals in 2 and collisions in 3 by convention.
inline constexpr int kLastDrawnGroup = 2;

struct MjcfGeom {
  model::Geometry geometry;
  model::Pose X_BG;  ///< of the shape, in the frame that the geom is written in
  bool touches = false;
  bool drawn = false;
  std::optional<model::GeomWeight> weight;
  std::array<double, 4> rgba{0.5, 0.5, 0.5, 1};
  bool fitted = false;  ///< a primitive that MuJoCo fits to a mesh: here it is the mesh
};

/// `in_pair`: a contact pair names the geom, so that it touches whatever its bit masks.
enum class InPair : std::uint8_t { kNo, kYes };

MjcfGeom mjcf_geom(const MjcfValues& values, const MjcfSettings& settings, MjcfAssets& assets,
                   InPair in_pair);

}  // namespace rigor::read
