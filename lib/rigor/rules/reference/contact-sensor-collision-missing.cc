// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::contact_sensor_collision_missing {

void check(const model::Sensor& sensor, Context& context) {
  if (!sensor.link || sensor.contact_collisions.empty()) return;
  const model::Root& root = context.root();
  std::unordered_set<std::string_view> names;
  for (const auto id : root[sensor.link].collisions) names.insert(root[id].name.value);
  const auto all = [&root, &sensor] {
    std::vector<std::string> list;
    for (const auto id : root[sensor.link].collisions) list.push_back(root[id].name.value);
    return list;
  };
  for (const model::Field<std::string>& collision : sensor.contact_collisions) {
    const std::string& name = collision.value;
    // A scoped name leads to another link, which the simulators understand in ways of their own.
    if (name.empty() || name.find("::") != std::string::npos) continue;
    if (names.contains(name)) continue;
    context.report(with_nearest(
        {.where = collision.span,
         .message = "the contact sensor watches the collision '" + name + "', which its link '" +
                    root[sensor.link].name.value + "' does not have",
         .subject = context.subject(sensor)},
        name, all, context));
  }
}

Rule rule() {
  return {
      .name = "contact-sensor-collision-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a contact sensor watches a collision that its link does not have",
      .why = "Gazebo looks for the name among the collisions of the sensor's own link, finds none, "
             "and the sensor never reports a contact.",
      .what_to_do = "Name a collision of the same link.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::contact_sensor_collision_missing
