// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Types of sensors that gz-sim has and Gazebo classic's SensorFactory does not.
//
//   const NewSensorType* type = new_sensor_type(sensor.type.value);  // null for what classic has
//   if (type != nullptr && !type->in_classic.empty()) …

#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

namespace rigor::rules {

struct NewSensorType {
  std::string_view name;
  std::string_view in_classic;  ///< empty when there is none
};

inline constexpr NewSensorType kNewSensorTypes[] = {
    {"air_pressure", ""},        {"air_speed", ""},
    {"boundingbox", ""},         {"boundingbox_camera", ""},
    {"depth_camera", "depth"},   {"dvl", ""},
    {"gpu_lidar", "gpu_ray"},    {"lidar", "ray"},
    {"navsat", "gps"},           {"rgbd", ""},
    {"rgbd_camera", ""},         {"segmentation", ""},
    {"segmentation_camera", ""}, {"thermal", ""},
    {"thermal_camera", ""},      {"wide_angle_camera", "wideanglecamera"}};

inline const NewSensorType* new_sensor_type(std::string_view type) {
  const auto* const found =
      std::find_if(std::begin(kNewSensorTypes), std::end(kNewSensorTypes),
                   [type](const NewSensorType& one) { return one.name == type; });
  return found == std::end(kNewSensorTypes) ? nullptr : found;
}

}  // namespace rigor::rules
