// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::force_torque_on_link {

void check(const model::Sensor& sensor, Context& context) {
  if (sensor.type.value != "force_torque" || !sensor.link) return;
  context.report({.where = sensor.type.span,
                  .message = "a force-torque sensor is in the link '" +
                             context.root()[sensor.link].name.value +
                             "': Gazebo makes none there, only in a joint",
                  .subject = context.subject(sensor)});
}

Rule rule() {
  return {
      .name = "force-torque-on-link",
      .severity = Severity::kWarning,
      .summary = "force-torque sensor in a link",
      .why = "libsdformat accepts it in a link; Gazebo then logs that the parent of the sensor "
             "must be a joint, and does not create it. It measures what a joint transmits between "
             "two links.",
      .what_to_do = "Move it into the joint whose load it is to measure; in a URDF, into the "
                    "<gazebo> whose reference is the joint.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::force_torque_on_link
