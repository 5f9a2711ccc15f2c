// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/rules/plugin/drive_wheels.h>
#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::plugin_topic_shared {

struct Use {
  std::string_view library;
  std::string_view parameter;
  bool publishes;
};

/// Topics of systems that say something else on each.
constexpr Use kUses[] = {
    {"ackermann-steering", "odom_topic", true},
    {"ackermann-steering", "topic", false},
    {"diff-drive", "odom_topic", true},
    {"diff-drive", "topic", false},
    {"joint-controller", "topic", false},
    {"joint-position-controller", "topic", false},
    {"joint-state-publisher", "topic", true},
    {"joint-trajectory-controller", "topic", false},
    {"mecanum-drive", "odom_topic", true},
    {"mecanum-drive", "topic", false},
    {"odometry-publisher", "odom_topic", true},
    {"pose-publisher", "topic", true},
    {"thruster", "topic", false},
    {"tracked-vehicle", "odom_topic", true},
    {"tracked-vehicle", "topic", false},
    {"velocity-control", "topic", false},
};

struct Seen {
  const Use* use;
  const model::Parameter* parameter;
};

const Use* use_of(std::string_view library, std::string_view parameter) {
  for (const Use& use : kUses) {
    if (use.library == library && use.parameter == parameter) return &use;
  }
  return nullptr;
}

void check(const model::Root& root, Context& context) {
  std::map<std::pair<std::uint32_t, std::string_view>, Seen> seen;  // by model and topic
  for (const model::Plugin& plugin : root.plugins) {
    const GazeboSystem* system = gazebo_system(plugin.filename.value);
    if (system == nullptr || !plugin.model || !root.own(plugin.site)) continue;
    for (const model::Parameter& given : plugin.parameters) {
      const Use* use = use_of(system->library, given.name);
      if (use == nullptr || given.value.value.empty()) continue;
      const auto [entry, first] = seen.emplace(
          std::pair(plugin.model.value, std::string_view(given.value.value)), Seen{use, &given});
      // Two that publish odometry are another rule's; two that listen to one command may be meant.
      const Seen& other = entry->second;
      if (first || other.use->publishes == use->publishes) continue;
      context.report({.where = trimmed(given, context),
                      .message = "the plugins publish and subscribe '" + given.value.value +
                                 "', each another type of message",
                      .subject = context.subject(plugin),
                      .related = {{trimmed(*other.parameter, context), "the other topic"}}});
    }
  }
}

Rule rule() {
  return {
      .name = "plugin-topic-shared",
      .severity = Severity::kWarning,
      .summary = "one plugin of a model publishes on the topic that another one subscribes to",
      .why = "A command and a measurement are messages of different types: gz-transport refuses "
             "the second, or the plugin never gets what it waits for.",
      .what_to_do = "Give each its own topic.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::plugin_topic_shared
