// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The systems of a world of gz-sim that run its sensors.
//
//   const SensorSystem* system = sensor_system("imu");   // gz-sim-imu-system

#pragma once

#include <string>
#include <string_view>

namespace rigor::rules {

struct SensorSystem {
  std::string_view library;  ///< "imu" of gz-sim-imu-system
  std::string_view name;     ///< of the class, in gz::sim::systems
  std::string_view sensors;  ///< types that it runs, between blanks
};

inline constexpr SensorSystem kSensorSystems[] = {
    {"sensors", "Sensors",
     " camera depth depth_camera rgbd_camera rgbd gpu_lidar gpu_ray thermal_camera thermal "
     "segmentation_camera segmentation boundingbox_camera boundingbox wideanglecamera "
     "wide_angle_camera "},
    {"imu", "Imu", " imu "},
    {"contact", "Contact", " contact "},
    {"magnetometer", "Magnetometer", " magnetometer "},
    {"altimeter", "Altimeter", " altimeter "},
    {"air-pressure", "AirPressure", " air_pressure "},
    {"air-speed", "AirSpeed", " air_speed "},
    {"forcetorque", "ForceTorque", " force_torque "},
    {"navsat", "NavSat", " navsat gps "},
    {"logical-camera", "LogicalCamera", " logical_camera "},
};

/// The one that runs sensors of a type; null when none does.
inline const SensorSystem* sensor_system(std::string_view type) {
  if (type.empty() || type.find(' ') != std::string_view::npos) return nullptr;
  for (const SensorSystem& system : kSensorSystems) {
    if (system.sensors.find(' ' + std::string(type) + ' ') != std::string_view::npos)
      return &system;
  }
  return nullptr;
}

}  // namespace rigor::rules
