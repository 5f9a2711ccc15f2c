// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>

#include <rigor/rules/plugin/simulator.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::sensor_type_not_in_gz_sim {

/// Whether the file is for gz-sim alone, by the plugins that it has.
bool is_for_gz_sim(const model::Root& root) {
  bool any = false;
  for (const model::Plugin& plugin : root.plugins) {
    const std::string& library = plugin.filename.value;
    if (is_of_gazebo_classic(library) || library.find("cpu-lidar") != library.npos) return false;
    any = any || is_of_new_gazebo(library);
  }
  return any;
}

void check(const model::Sensor& sensor, Context& context) {
  const std::string& type = sensor.type.value;
  if ((type != "lidar" && type != "ray") || !is_for_gz_sim(context.root())) return;
  context.report(
      {.where = sensor.type.span,
       .message = "gz-sim makes no sensor of type '" + type + "'",
       .subject = context.subject(sensor),
       .fix = Fix{"write gpu_lidar", Applicability::kUnsafe, {{sensor.type.span, "gpu_lidar"}}}});
}

Rule rule() {
  return {
      .name = "sensor-type-not-in-gz-sim",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a lidar is of the type that gz-sim does not make",
      .why = "Up to Harmonic gz-sim logs \"Sensor type LIDAR not supported yet. Try using a GPU "
             "LIDAR instead\", and nothing is measured. It is reported in files with plugins of "
             "gz-sim, without its newer CPU lidar, and none of Gazebo classic, which has ray.",
      .what_to_do = "Write type=\"gpu_lidar\".",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::sensor_type_not_in_gz_sim
