// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include <rigor/rules/rule.h>

namespace rigor::rules::sensor_type_not_in_classic {

struct NewType {
  std::string_view name;
  std::string_view in_classic;  ///< empty when there is none
};

constexpr NewType kNew[] = {{"air_pressure", ""},        {"air_speed", ""},
                            {"boundingbox", ""},         {"boundingbox_camera", ""},
                            {"depth_camera", "depth"},   {"dvl", ""},
                            {"gpu_lidar", "gpu_ray"},    {"lidar", "ray"},
                            {"navsat", "gps"},           {"rgbd", ""},
                            {"rgbd_camera", ""},         {"segmentation", ""},
                            {"segmentation_camera", ""}, {"thermal", ""},
                            {"thermal_camera", ""},      {"wide_angle_camera", "wideanglecamera"}};

void check(const model::Sensor& sensor, Context& context) {
  const std::string& type = sensor.type.value;
  const auto is_it = [&type](const NewType& one) { return one.name == type; };
  const auto found = std::find_if(std::begin(kNew), std::end(kNew), is_it);
  if (found == std::end(kNew)) return;
  Finding finding{.where = sensor.type.span,
                  .message = "Gazebo classic has no " + type + " sensor",
                  .subject = context.subject(sensor)};
  if (!found->in_classic.empty()) {
    finding.help = "there it is called '" + std::string(found->in_classic) + "'";
  }
  context.report(finding);
}

Rule rule() {
  return {
      .name = "sensor-type-not-in-classic",
      .severity = Severity::kError,
      .targets = {Target::kGazeboClassic},
      .summary = "a sensor has a type that Gazebo classic does not have",
      .why = "Gazebo classic makes no sensor of it: types such as rgbd_camera, thermal_camera and "
             "air_pressure are those of gz-sim, and some have another name there, as gpu_lidar for "
             "gpu_ray.",
      .what_to_do = "Write the type that Gazebo classic has, if there is one.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::sensor_type_not_in_classic
