// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::actor_animation_missing {

void look_at(const model::Actor& actor, Context& context) {
  std::vector<std::string> animations;
  for (const auto& name : actor.animations) animations.push_back(name.value);
  const std::unordered_set<std::string_view> names(animations.begin(), animations.end());
  // One that only replaces what moves along a path has none.
  if (animations.empty()) return;
  for (const model::Trajectory& trajectory : actor.trajectories) {
    const auto& type = trajectory.type;
    if (type.value.empty() || names.count(type.value) != 0) continue;
    context.report(with_nearest(
        {.where = type.span,
         .message = "the trajectory plays '" + type.value +
                    "', which is no animation of the actor '" + actor.name.value + "'"},
        type.value, [&animations] { return animations; }, context));
  }
}

void check(const model::Root& root, Context& context) {
  for (const model::Actor& actor : root.actors) {
    if (root.own(actor.site)) look_at(actor, context);
  }
}

Rule rule() {
  return {
      .name = "actor-animation-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a trajectory of an actor plays an animation that the actor does not have",
      .why = "The type of a trajectory is the name of the animation that is played along it. When "
             "the actor has none of that name, it glides along the path without moving its legs, "
             "or stays where it is.",
      .what_to_do = "Name one of the actor's animations.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::actor_animation_missing
