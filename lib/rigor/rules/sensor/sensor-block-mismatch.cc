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

struct Block {
  std::string_view name;
  std::string_view types;  // that read it, between blanks
};

/// Elements with the settings of one kind of sensor.
constexpr Block kBlocks[] = {
    {"imu", " imu "},
    {"contact", " contact "},
    {"altimeter", " altimeter "},
    {"magnetometer", " magnetometer "},
    {"air_pressure", " air_pressure "},
    {"force_torque", " force_torque "},
    {"gps", " gps navsat "},
    {"navsat", " gps navsat "},
    {"logical_camera", " logical_camera "},
    {"sonar", " sonar "},
};

/// The block of another type, in a sensor whose own type has a block that is not there.
std::string_view other_block(const model::Sensor& sensor) {
  const std::string type = " " + sensor.type.value + " ";
  bool known = false;
  std::string_view other;
  for (const std::string_view name : sensor.settings) {
    if (name == "camera" || name == "lidar" || name == "ray") other = name;
    for (const Block& block : kBlocks) {
      if (block.name != name) continue;
      if (block.types.find(type) != std::string_view::npos) return {};
      other = name;
    }
  }
  for (const Block& block : kBlocks) {
    known = known || block.types.find(type) != std::string_view::npos;
  }
  return known ? other : std::string_view();
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
  if (message.empty()) {
    if (const std::string_view other = other_block(sensor); !other.empty()) {
      message =
          "a sensor of type '" + type + "' does not read the <" + std::string(other) + "> in it";
    }
  }
  // One without any settings is a stub: its plugin, or a test, makes something of it.
  if (message.empty() || sensor.settings.empty()) return;
  context.report({.where = sensor.type.span,
                  .message = std::move(message),
                  .subject = context.subject(sensor)});
}

Rule rule() {
  return {
      .name = "sensor-block-mismatch",
      .severity = Severity::kWarning,
      .summary = "a sensor lacks the element that its type needs, or has another type's",
      .why = "libsdformat accepts it; Gazebo then does not create the sensor, or creates it with "
             "defaults.",
      .what_to_do = "Add the element that the type needs, or write the type that fits.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::sensor_block_mismatch
