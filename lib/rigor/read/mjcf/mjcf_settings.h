// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What `<compiler>` says about reading the file. Of several the last that sets a value counts, wherever they are.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/model/model.h>
#include <rigor/read/mjcf/mjcf_tree.h>

namespace rigor::read {

struct MjcfSettings {
  enum class InertiaFromGeom : std::uint8_t { kFalse, kTrue, kAuto };

  bool degrees = true;
  std::string euler_sequence =
      "xyz";  ///< lower case: about the moved axes; upper case: about the fixed ones
  bool auto_limits = true;
  bool strip_path = false;
  bool fit_to_bounds =
      false;  ///< `fitaabb`: primitives are fitted to the bounds of meshes, not to their inertia
  std::string mesh_folder;
  std::string texture_folder;
  InertiaFromGeom inertia_from_geom = InertiaFromGeom::kAuto;
  std::array<int, 2> inertia_groups{0, 5};
  model::MassSettings masses;
  Span global_coordinates;  ///< of coordinate="global"; else nowhere

  /// rad, from an angle as the file writes it.
  double radians(double angle) const;
};

MjcfSettings mjcf_settings(const MjcfTree& tree);

/// All numbers of a list; nothing when something else is among them. Independent of the locale.
std::optional<std::vector<double>> mjcf_numbers(std::string_view text);

}  // namespace rigor::read
