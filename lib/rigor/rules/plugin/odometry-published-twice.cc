// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::odometry_published_twice {

constexpr std::string_view kPublishers[] = {"ackermann-steering", "diff-drive", "mecanum-drive",
                                            "odometry-publisher"};

bool publishes_odometry(const model::Plugin& plugin) {
  const GazeboSystem* const system = gazebo_system(plugin.filename.value);
  return system != nullptr && std::find(std::begin(kPublishers), std::end(kPublishers),
                                        system->library) != std::end(kPublishers);
}

/// Without a topic all of them take the one that is named after the model.
std::string topic_of(const model::Plugin& plugin) {
  const auto* topic = find(plugin.parameters, "odom_topic");
  return topic != nullptr ? topic->value.value : std::string();
}

void check(const model::Root& root, Context& context) {
  std::map<std::pair<std::uint32_t, std::string>, const model::Plugin*> seen;
  for (const model::Plugin& plugin : root.plugins) {
    if (!plugin.model || !root.own(plugin.site) || !publishes_odometry(plugin)) continue;
    const std::string topic = topic_of(plugin);
    const auto [entry, first] = seen.try_emplace({plugin.model.value, topic}, &plugin);
    if (first) continue;
    const model::Plugin& other = *entry->second;
    // The same plugin twice is what plugin-duplicate reports.
    if (context.bytes(plugin.site.span) == context.bytes(other.site.span)) continue;
    context.report({.where = plugin.site.name,
                    .message = topic.empty() ? "two plugins publish the odometry of the model"
                                             : "two plugins publish odometry on '" + topic + "'",
                    .subject = context.subject(plugin),
                    .related = {{other.site.name, "the first one"}}});
  }
}

Rule rule() {
  return {
      .name = "odometry-published-twice",
      .severity = Severity::kWarning,
      .summary = "two plugins publish the odometry of a model on one topic",
      .why = "The drive systems of Gazebo Sim publish odometry themselves, on /model/NAME/odometry "
             "unless they are given an odom_topic, and OdometryPublisher does on the same topic. "
             "One integrates wheel rotations, the other publishes the true pose: subscribers get "
             "both, mixed.",
      .what_to_do = "Give one of them its own odom_topic, or remove it.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::odometry_published_twice
