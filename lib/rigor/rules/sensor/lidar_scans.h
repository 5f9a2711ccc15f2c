// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Both scans of a lidar, for rules that ask the same of each.

#pragma once

#include <rigor/rules/context.h>

namespace rigor::rules {

template <void (*look_at)(const model::LidarScan&, const model::Sensor&, Context&)>
void check_scans(const model::Sensor& sensor, Context& context) {
  if (!sensor.lidar) return;
  look_at(sensor.lidar->horizontal, sensor, context);
  look_at(sensor.lidar->vertical, sensor, context);
}

}  // namespace rigor::rules
