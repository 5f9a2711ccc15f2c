// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/sensor/picture.h>

namespace rigor::rules::camera_image_empty {

void check(const model::Sensor& sensor, Context& context) {
  report_pictures(
      sensor, [](double pixels) { return !(pixels >= 1); }, context);
}

Rule rule() {
  return {
      .name = "camera-image-empty",
      .severity = Severity::kError,
      .summary = "a camera takes pictures without a pixel",
      .why = "ign sdf -k calls it valid (and takes -1 for four thousand million); the renderer "
             "then fails to make the picture, and Gazebo may stop.",
      .what_to_do = "Write the width and height in pixels, 1 and more.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::camera_image_empty
