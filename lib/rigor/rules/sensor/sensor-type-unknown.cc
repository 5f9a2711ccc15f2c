// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/kinematics/unknown_type.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::sensor_type_unknown {
namespace {

void check(const read::SchemaFact& fact, Context& context) {
  if (is_type_of(fact, "sensor")) report_unknown_type(fact, context);
}

void check_empty(const model::Sensor& sensor, Context& context) {
  report_empty_type(context.element(sensor.site), context.subject(sensor), context);
}

}  // namespace

Rule rule() {
  return {
      .name = "sensor-type-unknown",
      .category = Category::kSensor,
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a sensor has a type that does not exist",
      .why = "libsdformat refuses the whole file (error 5): it does not know what to measure.",
      .what_to_do =
          "Write one of the types, such as camera, gpu_lidar, imu, contact or "
          "force_torque; type=\"custom\" is for your own.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="head">
      <sensor name="eye" type="«gpu_ladar»">
      </sensor>
    </link>
  </model>
</sdf>
)",
               R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="head">
      <sensor name="eye" type="gpu_lidar">
      </sensor>
    </link>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="head">
      <sensor name="eye" type="imu">
      </sensor>
    </link>
  </model>
</sdf>
)"}},
      .checks = {on_schema({read::SchemaFactKind::kNotInEnumeration}, check),
                 on<model::Sensor>(check_empty)},
  };
}

}  // namespace rigor::rules::sensor_type_unknown
