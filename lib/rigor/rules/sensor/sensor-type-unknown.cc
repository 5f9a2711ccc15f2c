// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/kinematics/unknown_type.h>
#include <rigor/rules/plugin/gazebo_block.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::sensor_type_unknown {

void check(const read::SchemaFact& fact, Context& context) {
  if (is_type_of(fact, "sensor")) report_unknown_type(fact, context);
}

/// Those of SDF 1.12, for the <gazebo> of a URDF, where no schema is examined.
constexpr std::string_view kTypes[] = {"air_pressure",
                                       "air_speed",
                                       "altimeter",
                                       "boundingbox",
                                       "boundingbox_camera",
                                       "camera",
                                       "contact",
                                       "custom",
                                       "depth",
                                       "depth_camera",
                                       "wideangle_camera",
                                       "force_torque",
                                       "gps",
                                       "gpu_lidar",
                                       "gpu_ray",
                                       "imu",
                                       "lidar",
                                       "logical_camera",
                                       "magnetometer",
                                       "multicamera",
                                       "navsat",
                                       "ray",
                                       "rfid",
                                       "rfidtag",
                                       "rgbd",
                                       "rgbd_camera",
                                       "segmentation",
                                       "segmentation_camera",
                                       "sonar",
                                       "thermal",
                                       "thermal_camera",
                                       "wide_angle_camera",
                                       "wideanglecamera",
                                       "wireless_receiver",
                                       "wireless_transmitter"};

void check_block(const model::Sensor& sensor, Context& context) {
  const auto& type = sensor.type;
  if (!type.written) {
    return context.report({.where = sensor.site.name,
                           .message = "the sensor has no type",
                           .subject = context.subject(sensor)});
  }
  const auto* const end = std::end(kTypes);
  if (std::find(std::begin(kTypes), end, type.value) != end || has_xacro(type.value)) return;
  const std::vector<std::string_view> types(std::begin(kTypes), end);
  const auto near = schema::near(type.value, types);
  context.report(
      {.where = type.span,
       .message = "'" + type.value + "' is no type of sensor",
       .subject = context.subject(sensor),
       .help = near.empty() ? std::string() : "did you mean '" + std::string(near.front()) + "'?",
       .fix = nearest_instead(type.value, types, type.span)});
}

void check_sensor(const model::Sensor& sensor, Context& context) {
  if (context.is_urdf() && !is_in_part(sensor)) return;  // sensor-without-link
  const bool empty = sensor.type.written && sensor.type.value.empty();
  if (context.is_urdf() && !empty) return check_block(sensor, context);
  report_empty_type(sensor.site, context.subject(sensor), context);
}

Rule rule() {
  return {
      .name = "sensor-type-unknown",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .fix = FixGrade::kUnsafe,
      .summary = "a sensor has a type that does not exist",
      .why = "libsdformat rejects the whole file (error 5): it does not know what to measure.",
      .what_to_do = "Write one of the types, such as camera, gpu_lidar, imu, contact or "
                    "force_torque; type=\"custom\" is for your own.",
      .checks = {on_schema({read::SchemaFactKind::kNotInEnumeration}, check),
                 on<model::Sensor>(check_sensor)},
  };
}

}  // namespace rigor::rules::sensor_type_unknown
