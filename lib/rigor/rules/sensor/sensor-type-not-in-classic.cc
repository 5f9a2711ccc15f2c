// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/sensor/classic_sensor_types.h>

namespace rigor::rules::sensor_type_not_in_classic {

void check(const model::Sensor& sensor, Context& context) {
  const std::string& type = sensor.type.value;
  const NewSensorType* const found = new_sensor_type(type);
  if (found == nullptr) return;
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
