// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <utility>

#include <rigor/rules/plugin/drive_wheels.h>
#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::lift_drag_without_direction {

bool is_lift_drag(const model::Plugin& plugin) {
  const GazeboSystem* const system = gazebo_system(plugin.filename.value);
  return (system != nullptr && system->library == "lift-drag") ||
         plugin.filename.value == "libLiftDragPlugin.so";
}

/// Of a direction that is written; nothing where it is not three numbers.
std::optional<model::Vector3> vector_of(const model::Parameter& parameter) {
  const auto numbers = write::numbers_in(parameter.value.value);
  if (!numbers || numbers->size() != 3) return std::nullopt;
  return model::Vector3{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

void report(const model::Parameter& wrong, std::string message, const model::Plugin& plugin,
            Context& context) {
  context.report({.where = trimmed(wrong, context),
                  .message = std::move(message) + ": the surface has no lift",
                  .subject = context.subject(plugin)});
}

void check(const model::Plugin& plugin, Context& context) {
  if (!is_lift_drag(plugin)) return;
  const auto* symmetric = find(plugin.parameters, "radial_symmetry");
  const bool needs_upward = symmetric == nullptr || !model::is_true(*symmetric);
  const auto* forward = find(plugin.parameters, "forward");
  const auto* upward = needs_upward ? find(plugin.parameters, "upward") : nullptr;
  const auto along = forward != nullptr ? vector_of(*forward) : model::Vector3{1, 0, 0};
  const auto lift = upward != nullptr ? vector_of(*upward) : model::Vector3{0, 0, 1};
  if (along && length(*along) == 0) {
    report(*forward, "<forward> is 0 0 0, which is no direction", plugin, context);
  } else if (lift && length(*lift) == 0) {
    report(*upward, "<upward> is 0 0 0, which is no direction", plugin, context);
  } else if (needs_upward && along && lift && (forward != nullptr || upward != nullptr)) {
    constexpr double kParallel = 1e-6;  // sine
    if (length(cross(*along, *lift)) > kParallel * length(*along) * length(*lift)) return;
    report(upward != nullptr ? *upward : *forward, "<forward> and <upward> are parallel", plugin,
           context);
  }
}

Rule rule() {
  return {
      .name = "lift-drag-without-direction",
      .severity = Severity::kWarning,
      .summary = "a lift-drag plugin has no forward or upward direction",
      .why = "The plugin takes the span of the surface to be perpendicular to <forward> and "
             "<upward>, and the lift to be perpendicular to the span. With one of them zero, or "
             "both along one line, the lift is zero at any speed, and the drag is that of a "
             "surface across the flow.",
      .what_to_do = "Write the direction in which the surface moves as <forward>, and that of the "
                    "lift as <upward>, both in the frame of the link.",
      .checks = {on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::lift_drag_without_direction
