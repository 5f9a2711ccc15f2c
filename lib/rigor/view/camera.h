// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// From where a picture is taken.
//
//   const Camera camera = framing(drawing.bounds, View::kPerspective, 960.0 / 640);

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/pose.h>

namespace rigor::view {

enum class View : std::uint8_t {
  kPerspective,  ///< from the front, its left and above
  kFront,        ///< looking along -x, as at a robot that drives towards one; y to the right
  kSide,         ///< looking along -y: x to the left
  kTop,          ///< looking along -z: x up
  kBack,         ///< looking along x
};

/// "perspective", "front", "side", "top", "back"
std::string_view to_string(View view);
std::optional<View> view_named(std::string_view name);
std::vector<std::string_view> view_names();

/// A pinhole when `field_of_view` is positive; else parallel rays.
struct Camera {
  model::Vector3 eye;
  model::Vector3 forward;    ///< unit
  model::Vector3 right;      ///< unit, along the picture's rows
  model::Vector3 up;         ///< unit, along the picture's columns, upward
  double field_of_view = 0;  ///< rad, of the picture's height
  double height = 1;         ///< m, what the picture's height shows, when rays are parallel
};

/// So that `bounds` fills the picture but for a margin. `aspect` is width by height.
Camera framing(const mesh::Bounds& bounds, View view, double aspect);

/// Where a point falls: x and y in -1 to 1 from the left and from the bottom of the picture; nothing behind the eye.
struct Projected {
  double x = 0;
  double y = 0;
  double depth = 0;  ///< m along `forward`
};
std::optional<Projected> project(const Camera& camera, double aspect, const model::Vector3& point);

}  // namespace rigor::view
