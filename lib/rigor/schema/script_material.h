// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The materials of Gazebo's own script, by name.
//
//   if (const auto orange = find_material("Gazebo/Orange")) paint(orange->diffuse);

#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace rigor::schema {

/// A line of schemas/gazebo.materials; red, green, blue, and opacity where there is a fourth.
struct ScriptMaterial {
  std::string_view name;
  std::array<double, 3> ambient{};
  std::array<double, 4> diffuse{};
  std::array<double, 3> specular{};
  std::string_view texture;  ///< file name; empty where it has none
};

/// Nothing for a name that the text has not.
std::optional<ScriptMaterial> find_material(std::string_view text, std::string_view name);
/// Of Gazebo's own script.
std::optional<ScriptMaterial> find_material(std::string_view name);

}  // namespace rigor::schema
