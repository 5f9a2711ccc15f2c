// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <string>

#include <rigor/rules/plugin/simulator.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/sensor/classic_sensor_types.h>

namespace rigor::rules::sensor_type_not_for_plugin {

/// Whether the file is for gz-sim as well: then the type is right there, and the plugin is left over.
bool has_plugin_of_gz_sim(const model::Root& root) {
  return std::any_of(root.plugins.begin(), root.plugins.end(), [](const model::Plugin& plugin) {
    return is_of_new_gazebo(plugin.filename.value);
  });
}

void check(const model::Plugin& plugin, Context& context) {
  if (!plugin.sensor || !is_of_gazebo_classic(plugin.filename.value)) return;
  const model::Sensor& sensor = context.root()[plugin.sensor];
  const NewSensorType* const type = new_sensor_type(sensor.type.value);
  if (type == nullptr || has_plugin_of_gz_sim(context.root())) return;
  const std::string right(type->in_classic);
  const Span where = sensor.type.span;
  context.report({.where = where,
                  .message = "Gazebo classic has no " + sensor.type.value +
                             " sensor: the plugin '" + plugin.filename.value + "' is never loaded",
                  .subject = context.subject(sensor),
                  .related = {{plugin.filename.span, "a plugin of Gazebo classic"}},
                  .help = right.empty() ? "" : "there it is called '" + right + "'",
                  .fix = right.empty() ? std::nullopt
                                       : std::optional(Fix{"write '" + right + "'",
                                                           Applicability::kUnsafe,
                                                           {{where, right}}})});
}

Rule rule() {
  return {
      .name = "sensor-type-not-for-plugin",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a sensor with a plugin of Gazebo classic has a type of gz-sim",
      .why = "Gazebo classic logs \"Unable to create sensor of type\" and makes no sensor, so its "
             "plugin publishes nothing: gpu_lidar, depth_camera and others are types of gz-sim, "
             "which cannot load the plugin. In files that also have plugins of gz-sim it is not "
             "reported.",
      .what_to_do = "Write the type that Gazebo classic has, gpu_ray or depth; or, for gz-sim, "
                    "remove the plugin and load gz-sim-sensors-system in the world.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::sensor_type_not_for_plugin
