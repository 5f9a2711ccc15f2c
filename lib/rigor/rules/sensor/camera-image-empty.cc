// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::camera_image_empty {

void check(const model::Sensor& sensor, Context& context) {
  for (const model::Camera& camera : sensor.cameras) {
    for (const auto* size : {&camera.width, &camera.height}) {
      if (!size->written || size->value >= 1) continue;
      context.report({.where = size->span,
                      .message = fmt::format("the picture is {} by {} pixels", camera.width.value,
                                             camera.height.value),
                      .subject = context.subject(sensor)});
      break;
    }
  }
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
