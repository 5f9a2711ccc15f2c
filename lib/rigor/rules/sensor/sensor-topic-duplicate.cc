// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <map>
#include <string_view>
#include <utility>

#include <rigor/rules/rule.h>

namespace rigor::rules::sensor_topic_duplicate {

void check(const model::Root& root, Context& context) {
  using Topic = std::pair<std::string_view, std::string_view>;  // and the type
  std::map<Topic, const model::Sensor*> seen;
  for (const model::Sensor& sensor : root.sensors) {
    const std::string& topic = sensor.topic.value;
    // Bumpers of one robot often share a topic, each message naming its own collision; and
    // __default_topic__ represents a name that the simulator makes up.
    if (!root.own(sensor.site) || topic.empty() || topic == "__default_topic__") continue;
    if (sensor.type.value == "contact") continue;
    const auto [entry, first] = seen.emplace(Topic{sensor.type.value, topic}, &sensor);
    if (first) continue;
    context.report(
        {.where = sensor.topic.span,
         .message = "two sensors of type '" + sensor.type.value + "' publish on '" + topic + "'",
         .subject = context.subject(sensor),
         .related = {{entry->second->topic.span, "the first one"}}});
  }
}

Rule rule() {
  return {
      .name = "sensor-topic-duplicate",
      .severity = Severity::kWarning,
      .summary = "two sensors publish on the same topic",
      .why = "Subscribers receive the measurements of both, mixed.",
      .what_to_do = "Give each sensor its own topic.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::sensor_topic_duplicate
