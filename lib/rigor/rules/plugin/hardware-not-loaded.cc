// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/plugin/drive_wheels.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::hardware_not_loaded {

/// A Gazebo, by the classes of hardware that its plugin loads.
struct Simulator {
  std::string_view name;
  std::string_view plugin;    ///< what loads its hardware
  std::string_view hardware;  ///< the usual class
};

constexpr Simulator kClassic{"Gazebo classic", "libgazebo_ros2_control.so",
                             "gazebo_ros2_control/GazeboSystem"};
constexpr Simulator kNew{"gz-sim", "gz_ros2_control-system", "gz_ros2_control/GazeboSimSystem"};

/// gz_ros2_control was called ign_ros2_control.
const Simulator* simulator_of_hardware(std::string_view name) {
  if (name.starts_with("gazebo_ros2_control/")) return &kClassic;
  if (name.starts_with("gz_ros2_control/") || name.starts_with("ign_ros2_control/")) return &kNew;
  return nullptr;
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != text.npos;
}

/// Null for a plugin that loads no hardware. That of ROS 1 loads none of ROS 2, and is of classic.
const Simulator* simulator_of_plugin(const model::Plugin& plugin) {
  const std::string& file = plugin.filename.value;
  if (contains(file, "gz_ros2_control") || contains(file, "ign_ros2_control")) return &kNew;
  return contains(file, "gazebo_ros2_control") ? &kClassic : nullptr;
}

bool is_of_ros1(const model::Plugin& plugin) {
  return contains(plugin.filename.value, "gazebo_ros_control");
}

/// Whether another plugin may load hardware: a laboratory's own.
bool may_load(const model::Plugin& plugin) {
  return simulator_of_plugin(plugin) == nullptr && contains(plugin.filename.value, "control") &&
         contains(plugin.filename.value, "ros2");
}

/// The plugin that was to load it, and does not; null where another does, or may.
struct Loaders {
  bool right = false;
  const model::Plugin* wrong = nullptr;
};

Loaders loaders_of(const Simulator& simulator, const model::Root& root) {
  Loaders result;
  for (const model::Plugin& plugin : root.plugins) {
    const Simulator* const of_plugin = simulator_of_plugin(plugin);
    if (of_plugin == &simulator || may_load(plugin)) result.right = true;
    if ((of_plugin && of_plugin != &simulator) || is_of_ros1(plugin)) result.wrong = &plugin;
  }
  return result;
}

void check_hardware(const model::Parameter& named, Context& context) {
  const std::string& name = named.value.value;
  const Simulator* const simulator = simulator_of_hardware(name);
  if (simulator == nullptr) return;
  const Loaders loaders = loaders_of(*simulator, context.root());
  if (loaders.right) return;
  const std::string help = fmt::format("load {} in a <gazebo> block", simulator->plugin);
  if (loaders.wrong != nullptr) {
    const bool old = is_of_ros1(*loaders.wrong);
    const Simulator& other = simulator == &kNew ? kClassic : kNew;
    context.report(
        {.where = trimmed(named, context),
         .message = fmt::format("the plugin '{}' cannot load '{}', which is hardware of {}",
                                loaders.wrong->filename.value, name, simulator->name),
         .related = {{loaders.wrong->filename.span,
                      old ? "a plugin of ROS 1" : "a plugin of the other Gazebo"}},
         .help = old ? help : fmt::format("write {}, or {}", other.hardware, help)});
  } else if (!context.root().plugins.empty()) {
    context.report({.where = trimmed(named, context),
                    .message = fmt::format("no plugin of the robot loads '{}', the hardware of {}",
                                           name, simulator->name),
                    .help = help,
                    .severity = Severity::kWarning});
  }
}

void check(const model::Root& root, Context& context) {
  // A fragment of a robot has its plugins elsewhere.
  if (root.links.empty() || root.joints.empty()) return;
  for (const model::Parameter& control : root.ros2_controls) {
    if (!root.own(control.site)) continue;
    const auto* hardware = find(control.children, "hardware");
    const auto* named = hardware != nullptr ? find(hardware->children, "plugin") : nullptr;
    if (named != nullptr) check_hardware(*named, context);
  }
}

Rule rule() {
  return {
      .name = "hardware-not-loaded",
      .severity = Severity::kError,
      .formats = Formats::kUrdf,
      .summary = "no plugin loads the ros2_control hardware of a Gazebo",
      .why = "Each Gazebo has a plugin that loads the classes of hardware written for it, and no "
             "others: the plugin logs that the class failed to load, the joints have no "
             "interfaces, and no controller starts. Where the robot has plugins, but none for "
             "ros2_control, it is a warning: a launch file may load one.",
      .what_to_do = "gz-sim: gz_ros2_control/GazeboSimSystem and the plugin "
                    "gz_ros2_control-system. Gazebo classic: gazebo_ros2_control/GazeboSystem and "
                    "libgazebo_ros2_control.so. libgazebo_ros_control.so is of ROS 1.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::hardware_not_loaded
