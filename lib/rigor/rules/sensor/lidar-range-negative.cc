// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::lidar_range_negative {
namespace {

void check(const model::Sensor& sensor, Context& context) {
  if (!sensor.lidar) return;
  const auto& least = sensor.lidar->range_min;
  if (!least.written || !(least.value < 0)) return;
  context.report({.where = least.span,
                  .message = fmt::format("the lidar measures from {} m on: no distance is negative",
                                         least.value),
                  .subject = context.subject(sensor)});
}

}  // namespace

Rule rule() {
  return {
      .name = "lidar-range-negative",
      .category = Category::kSensor,
      .severity = Severity::kWarning,
      .summary = "the least distance of a lidar is negative",
      .why =
          "No reader complains. Rendering takes it for the near plane of a camera, which lies in "
          "front of it; a negative one shows nothing, or what is behind.",
      .what_to_do = "Write the distance in metres from which on the lidar sees, at least 0.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="head">
      <sensor name="scanner" type="gpu_lidar">
        <lidar>
          <scan>
            <horizontal>
              <samples>360</samples>
              <resolution>1</resolution>
              <min_angle>-1.4</min_angle>
              <max_angle>1.4</max_angle>
            </horizontal>
          </scan>
          <range>
            <min>«-0.1»</min>
            <max>30</max>
          </range>
        </lidar>
      </sensor>
    </link>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="head">
      <sensor name="scanner" type="gpu_lidar">
        <lidar>
          <scan>
            <horizontal>
              <samples>360</samples>
              <resolution>1</resolution>
              <min_angle>-1.4</min_angle>
              <max_angle>1.4</max_angle>
            </horizontal>
          </scan>
          <range>
            <min>0.1</min>
            <max>30</max>
          </range>
        </lidar>
      </sensor>
    </link>
  </model>
</sdf>
)"}},
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::lidar_range_negative
