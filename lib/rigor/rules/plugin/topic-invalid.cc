// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/read/values.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>

namespace rigor::rules::topic_invalid {

/// Parameters of plugins that are topics wherever they are used. Those of gazebo_ros may begin with `~`.
constexpr std::string_view kTopics[] = {"topic",        "odom_topic",   "tf_topic",
                                        "sub_topic",    "detach_topic", "attach_topic",
                                        "output_topic", "topicName",    "topic_name"};

/// What no topic of Gazebo or ROS may hold; empty when the topic is a good one.
std::string_view forbidden_in(std::string_view topic) {
  for (const std::string_view part : {" ", "//", "@", ":="}) {
    if (topic.find(part) != std::string_view::npos) return part;
  }
  return {};
}

/// As Gazebo rewrites it where it does.
std::string valid(std::string_view topic) {
  std::string text;
  for (std::size_t i = 0; i < topic.size(); ++i) {
    const bool repeated = topic[i] == '/' && !text.empty() && text.back() == '/';
    const bool assignment = topic.substr(i).starts_with(":=");
    if (assignment) ++i;
    if (repeated || assignment || topic[i] == '@') continue;
    text += topic[i] == ' ' ? '_' : topic[i];
  }
  return text;
}

void look_at(std::string_view topic, Span where, std::string subject, Context& context) {
  const std::string_view forbidden = forbidden_in(topic);
  if (forbidden.empty() || has_xacro(topic)) return;
  const std::string good = valid(topic);
  std::optional<Fix> fix;
  if (!good.empty() && read::trimmed(context.bytes(where)) == topic) {
    fix = Fix{"write '" + good + "'", Applicability::kUnsafe, {{where, good}}};
  }
  const std::string what = forbidden == " " ? "a space" : "'" + std::string(forbidden) + "'";
  context.report({.where = where,
                  .message = "the topic '" + std::string(topic) + "' has " + what + " in it",
                  .subject = std::move(subject),
                  .fix = std::move(fix)});
}

void check_sensor(const model::Sensor& sensor, Context& context) {
  const auto& topic = sensor.topic;
  if (topic.written) look_at(topic.value, topic.span, context.subject(sensor), context);
}

void check_plugin(const model::Plugin& plugin, Context& context) {
  for (const model::Parameter& given : plugin.parameters) {
    if (std::find(std::begin(kTopics), std::end(kTopics), given.name) == std::end(kTopics)) {
      continue;
    }
    look_at(given.value.value, given.value.span, context.subject(plugin), context);
  }
}

Rule rule() {
  return {
      .name = "topic-invalid",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the name of a topic holds what no topic may",
      .why = "Gazebo allows no space, no '//', no '@' and no ':=' in a topic; ROS neither. Where "
             "Gazebo makes a valid name of it (a space becomes '_', the others vanish), the topic "
             "is not the one that others listen on; where it does not, nothing is published.",
      .what_to_do = "Use letters, digits, '_' and single '/'.",
      .checks = {on<model::Sensor>(check_sensor), on<model::Plugin>(check_plugin)},
  };
}

}  // namespace rigor::rules::topic_invalid
