// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/rules/rule.h>

namespace rigor::rules::sensor_block_mismatch {

constexpr std::string_view kCameras[] = {"camera",
                                         "depth",
                                         "depth_camera",
                                         "rgbd",
                                         "rgbd_camera",
                                         "thermal",
                                         "thermal_camera",
                                         "segmentation",
                                         "segmentation_camera",
                                         "boundingbox",
                                         "boundingbox_camera",
                                         "multicamera",
                                         "wideanglecamera",
                                         "wide_angle_camera"};

constexpr std::string_view kLidars[] = {"lidar", "gpu_lidar", "ray", "gpu_ray"};

template <std::size_t count>
bool contains(const std::string_view (&list)[count], std::string_view type) {
  return std::find(std::begin(list), std::end(list), type) != std::end(list);
}

void check(const model::Sensor& sensor, Context& context) {
  const std::string& type = sensor.type.value;
  const bool camera = !sensor.cameras.empty();
  const bool lidar = sensor.lidar.has_value();
  std::string message;
  if (contains(kCameras, type) && !camera) {
    message = "a sensor of type '" + type + "' needs a <camera>";
    if (lidar) message += "; this one has a <lidar>";
  } else if (contains(kLidars, type) && !lidar) {
    message = "a sensor of type '" + type + "' needs a <lidar>";
    if (camera) message += "; this one has a <camera>";
  }
  // One without any settings is a stub: its plugin, or a test, makes something of it.
  if (message.empty() || !sensor.configured) return;
  context.report({.where = sensor.type.span,
                  .message = std::move(message),
                  .subject = context.subject(sensor)});
}

Rule rule() {
  return {
      .name = "sensor-block-mismatch",
      .severity = Severity::kWarning,
      .summary = "a sensor lacks the element that its type needs",
      .why = "libsdformat takes it; Gazebo then does not make the sensor, or makes it with "
             "defaults that nobody wrote.",
      .what_to_do = "Add the element that the type needs, or write the type that fits.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::sensor_block_mismatch
