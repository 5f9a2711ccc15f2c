// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a model's own material script (Ogre's format, as Gazebo classic reads it) says of a color and its
// picture; programs of the renderer are passed over. Private to the room.
//
//   const auto paint = find_in_script(text, "StartingPen/Floor");
//   if (paint && !paint->texture.empty()) look_for(paint->texture);

#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace rigor::view {

struct ScriptPaint {
  std::optional<std::array<double, 4>> diffuse;  ///< as it is written; nothing where it is not
  std::string texture;                           ///< of the first texture unit; empty without one
};

/// Of the first material of that name: the first color and picture in it. What it lacks, the material that it
/// names as its parent has, when that stands before it. Nothing where the text has no such material.
std::optional<ScriptPaint> find_in_script(std::string_view text, std::string_view name);

}  // namespace rigor::view
