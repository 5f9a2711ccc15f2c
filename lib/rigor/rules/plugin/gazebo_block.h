// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Sensors and plugins in the <gazebo> blocks of a URDF.

#pragma once

#include <rigor/model/model.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// Whether the sensor's block refers to a part of the robot. What stands in a block that refers to the
/// whole robot comes into the model beside its links, where no consumer looks at it.
inline bool is_in_part(const model::Sensor& sensor) {
  return sensor.link || sensor.joint || !sensor.gazebo_reference.empty();
}

/// Whether libsdformat reads the plugin of a URDF, and so refuses what is wrong with it. One that is reported
/// of a link itself it passes on unread.
inline bool is_read_from_block(const model::Plugin& plugin, const Context& context) {
  if (plugin.sensor) return is_in_part(context.root()[plugin.sensor]);
  return plugin.gazebo_reference.empty();
}

}  // namespace rigor::rules
