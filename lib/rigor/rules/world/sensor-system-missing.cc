// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/world/sensor_systems.h>

namespace rigor::rules::sensor_system_missing {

struct Prefix {
  std::string_view library;
  std::string_view name;
};
constexpr Prefix kPrefixes[] = {{"gz-sim-", "gz::sim::systems::"},
                                {"ignition-gazebo-", "ignition::gazebo::systems::"}};

/// What the libraries of the world's own systems are called; null when it loads none, and then the
/// simulator's own list counts, or it is for Gazebo classic.
const Prefix* prefix_in(const model::Root& root) {
  for (const model::Plugin& plugin : root.plugins) {
    if (!plugin.world) continue;
    for (const Prefix& prefix : kPrefixes) {
      if (plugin.filename.value.find(prefix.library) != std::string::npos) return &prefix;
    }
  }
  return nullptr;
}

/// By its library or its class: a plugin that names one of them only is another rule's fault.
bool is_loaded(const SensorSystem& system, const model::Root& root) {
  const std::string library = fmt::format("-{}-system", system.library);
  const std::string name = fmt::format("::systems::{}", system.name);
  return std::any_of(root.plugins.begin(), root.plugins.end(), [&](const model::Plugin& plugin) {
    return plugin.filename.value.find(library) != std::string::npos ||
           plugin.name.value.find(name) != std::string::npos;
  });
}

const model::Sensor* sensor_for(const SensorSystem& system, const model::Root& root) {
  for (const model::Sensor& sensor : root.sensors) {
    if (sensor_system(sensor.type.value) == &system) return &sensor;
  }
  return nullptr;
}

struct Unserved {
  std::string systems;   // "gz-sim-imu-system and gz-sim-contact-system"
  std::string types;     // "imu, contact"
  std::string elements;  // their <plugin> elements
  std::uint32_t count = 0;
  const model::Sensor* first = nullptr;  // in the order of the file
};

Unserved unserved_by(const Prefix& prefix, const model::Root& root) {
  Unserved unserved;
  for (const SensorSystem& system : kSensorSystems) {
    const model::Sensor* sensor = sensor_for(system, root);
    if (sensor == nullptr || is_loaded(system, root)) continue;
    const std::string_view comma = unserved.count == 0 ? "" : ", ";
    unserved.systems += fmt::format("{}{}{}-system", comma, prefix.library, system.library);
    unserved.types += fmt::format("{}{}", comma, sensor->type.value);
    unserved.elements += fmt::format(R"({}<plugin filename="{}{}-system" name="{}{}"/>)",
                                     unserved.count == 0 ? "" : "\n", prefix.library,
                                     system.library, prefix.name, system.name);
    if (unserved.first == nullptr || sensor < unserved.first) unserved.first = sensor;
    ++unserved.count;
  }
  return unserved;
}

/// Behind the plugins that the world has.
std::optional<Fix> load_them(const Unserved& unserved, const model::World& world,
                             const Context& context) {
  Span last;
  for (const model::Plugin& plugin : context.root().plugins) {
    const bool inside = plugin.world && &context.root()[plugin.world] == &world;
    if (inside && context.root().own(plugin.site)) last = plugin.site.tag;
  }
  return fix_of(fmt::format("load {}", unserved.systems), Applicability::kUnsafe,
                inserted(context, world.site, last, unserved.elements));
}

void check(const model::World& world, Context& context) {
  const model::Root& root = context.root();
  if (root.worlds.size() != 1 || root.sensors.empty()) return;
  const Prefix* prefix = prefix_in(root);
  if (prefix == nullptr) return;
  const Unserved unserved = unserved_by(*prefix, root);
  if (unserved.first == nullptr) return;
  const model::Sensor& first = *unserved.first;
  const bool own = root.own(first.site);
  const std::string reported =
      unserved.count == 1
          ? fmt::format("the {} sensor '{}' publishes nothing", first.type.value, first.name.value)
          : fmt::format("the sensor '{}' and others publish nothing (types {})", first.name.value,
                        unserved.types);
  context.report({.where = own ? first.site.name : world.site.name,
                  .message = fmt::format("{}: the world loads systems, but not {}", reported,
                                         unserved.systems),
                  .subject = own ? context.subject(first) : context.subject(world),
                  .fix = load_them(unserved, world, context)});
}

Rule rule() {
  return {
      .name = "sensor-system-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a world with sensors does not load the system that runs them",
      .why = "Without its system the sensor exists and publishes nothing, without a warning. In "
             "Gazebo Sim each kind of sensor is run by a system plugin of the world: cameras and "
             "GPU lidars by Sensors, an IMU by Imu, a contact sensor by Contact. The default "
             "server.config loads physics, user commands and the scene broadcaster only. A world "
             "is reported once, at the first of its sensors.",
      .what_to_do = "Add the system's <plugin> to the world. Where the launch file or a "
                    "server.config of your own loads it, ignore the rule.",
      .checks = {on<model::World>(check)},
  };
}

}  // namespace rigor::rules::sensor_system_missing
