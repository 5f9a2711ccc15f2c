// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::physics_system_missing {

bool has(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

const model::Plugin* first_system(const model::Root& root) {
  const auto found = std::find_if(root.plugins.begin(), root.plugins.end(), [](const auto& plugin) {
    return plugin.world &&
           (has(plugin.filename.value, "gz-sim") || has(plugin.filename.value, "ignition-gazebo"));
  });
  return found == root.plugins.end() ? nullptr : &*found;
}

/// Whether a joint of a model that is not static is there to move.
bool has_moving_joint(const model::Root& root) {
  return std::any_of(root.joints.begin(), root.joints.end(), [&](const model::Joint& joint) {
    return joint.model && joint.type != model::JointType::kFixed && !is_static(root, joint.model);
  });
}

void check(const model::World& world, Context& context) {
  const model::Root& root = context.root();
  const model::Plugin* first = first_system(root);
  if (root.worlds.size() != 1 || first == nullptr || !has_moving_joint(root)) return;
  for (const model::Plugin& plugin : root.plugins) {
    if (has(plugin.filename.value, "physics") || has(plugin.name.value, "::Physics")) return;
    // It plays what another run has computed.
    if (has(plugin.filename.value, "log-system") && has(plugin.name.value, "LogPlayback")) return;
  }
  const bool old = has(first->filename.value, "ignition");
  const std::string system = old ? "ignition-gazebo-physics-system" : "gz-sim-physics-system";
  const std::string name = old ? "ignition::gazebo::systems::Physics" : "gz::sim::systems::Physics";
  context.report(
      {.where = world.site.name,
       .message = "the world loads systems, but not " + system + ": nothing moves",
       .subject = context.subject(world),
       .fix = fix_of("load " + system, Applicability::kUnsafe,
                     inserted(context, world.site, {},
                              "<plugin filename=\"" + system + "\" name=\"" + name + "\"/>"))});
}

Rule rule() {
  return {
      .name = "physics-system-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a world with joints loads systems of Gazebo Sim, and not the one for physics",
      .why = "Gazebo Sim loads its default systems only for a world that names none. With one "
             "system in the world and no Physics time passes and nothing falls, turns or "
             "collides, without a warning.",
      .what_to_do = "Add the system's <plugin> to the world, and those of UserCommands and "
                    "SceneBroadcaster where they are missing, too.",
      .checks = {on<model::World>(check)},
  };
}

}  // namespace rigor::rules::physics_system_missing
