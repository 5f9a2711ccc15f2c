// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How a model begins and stands.

#include <cmath>
#include <span>

#include <rigor/rules/simulate/rows.h>

namespace rigor::rules::simulation {

using simulate::FactKind;

std::span<const Row> stand_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"simulate-spawned-in-ground", FactKind::kSpawnedInGround, Severity::kError},
       .message = "begins {value_mm:.3g} mm inside the ground (limit {limit_mm:.3g} mm)",
       .summary = "the model begins inside the ground",
       .why = "The engine pushes it out: with SDFormat's default of 100 m/s a centimeter becomes a "
              "jump of meters; with Gazebo's own limit it rises slowly and shakes.",
       .what_to_do = "Raise the model's or the link's pose by the depth."},
      {.rule = {"simulate-spawned-above", FactKind::kSpawnedAbove, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return std::isfinite(fact.value)
                        ? "begins {value_length} above the ground (limit {limit_length})"
                        : "nothing in the world is below it: it falls, and its fall was not judged";
           },
       .summary = "the model begins above the ground and falls",
       .why = "Every start is a drop test: joints are jerked, and what is measured first is the "
              "fall. In a world, a model that falls for long is not judged by rest.",
       .what_to_do = "Lower the model's or the link's pose by the gap; give a world a ground."},
      {.rule = {"simulate-does-not-stand", FactKind::kHeldUp, Severity::kWarning},
       .message = "does not stand by itself, it tips over; it was simulated with its base held",
       .summary = "the model tips over where nothing holds it",
       .why = "Its center of mass is not above what it stands on. A robot that is bolted down in "
              "use need not stand; what is set on the ground falls over.",
       .what_to_do =
           "Widen the stance or move the masses; join the base to `world` if it is bolted "
           "down; `--base fixed` accepts it as it is, `--base free` shows the fall."},
      {.rule = {"simulate-self-overlap", FactKind::kSelfOverlap, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name.empty() ? "overlaps another link by {value_mm:.3g} mm at the start "
                                        "(limit {limit_mm:.3g} mm)"
                                      : "overlaps {name} by {value_mm:.3g} mm at the start (limit "
                                        "{limit_mm:.3g} mm)";
           },
       .summary = "links that no joint connects overlap where the model begins",
       .why = "When they collide, the engine pushes them apart with all it has: this is what makes "
              "robots explode when they are spawned.",
       .what_to_do = "Move one of them, make a collision smaller, or connect them by a joint."},
      {.rule = {"simulate-never-settles", FactKind::kNeverSettles, Severity::kError},
       .message = "is not at rest before {value:.3g} s (limit {limit:.3g} s)",
       .summary = "the model does not come to rest",
       .why = "It was only set down. Something keeps moving it: contacts that fight, a joint "
              "without damping, an inertia that is far too small, a wheel that rolls away.",
       .what_to_do = "Give joints that swing freely some damping; check inertias with `rigor "
                     "inertia MODEL`."},
      {.rule = {"simulate-residual-velocity", FactKind::kRestless, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "rest.contacts" ? "contacts come and go {value:.3g} times a "
                                                   "second at rest (limit {limit:.3g})"
                                                 : "still moves with {value_mm:.3g} mm/s at rest "
                                                   "(limit {limit_mm:.3g} mm/s)";
           },
       .summary = "the model does not settle",
       .why = "A model at rest keeps a residual velocity: sensors see noise that no real robot "
              "has, and the pose drifts.",
       .what_to_do = "Replace mesh collisions that touch the ground by primitives, and give small "
                     "links their true inertia."},
      {.rule = {"simulate-creeps", FactKind::kCreeps, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "yaw"
                        ? "residual angular velocity {value:.3g} rad/s at rest (limit {limit:.3g} "
                          "rad/s)"
                        : "creeps with {value_mm:.3g} mm/s at rest (limit {limit_mm:.3g} mm/s)";
           },
       .summary = "the model creeps at rest",
       .why = "It moves or turns on level ground without a command. A robot that is parked must be "
              "where it was parked.",
       .what_to_do = "Check that its support is symmetric, that wheels are not driven by a spring "
                     "or by gravity, and the friction of its contacts."},
      {.rule = {"simulate-ground-reaction-missing", FactKind::kUnbalanced, Severity::kError},
       .message = "has a ground reaction force {value_percent:.4g} % off its weight at rest "
                  "(limit {limit_percent:.3g} %)",
       .summary = "the ground does not bear the model's weight",
       .why = "At rest, what the ground pushes back must be the weight. Here it is not: something "
              "of the model falls, bounces or goes through the ground.",
       .what_to_do = "Give each link that should touch the ground a collision, and a joint to each "
                     "link that is not to fall."},
      {.rule = {"simulate-tips", FactKind::kTips, Severity::kError},
       .message = "tips over: its base leans by {value_deg:.3g}° (limit {limit_deg:.3g}°)",
       .summary = "the model tips over",
       .why = "Its base leans far from how it began: it fell over, or something threw it over.",
       .what_to_do = "Bring the center of mass over the support: lower or move masses, widen the "
                     "stance, add the caster that is missing."},
      {.rule = {"simulate-nearly-tips", FactKind::kNearlyTips, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             return fact.value < 0 ? "has its center of mass outside its support by "
                                     "{deficit_percent:.3g} % of "
                                     "half the support's width"
                                   : "has its center of mass inside its support by only "
                                     "{value_percent:.3g} % of half the support's width (limit "
                                     "{limit_percent:.3g} %)";
           },
       .summary = "the center of mass is near the edge of the support",
       .why = "A push, a slope or a brake will tip it over that edge.",
       .what_to_do = "Widen the stance, or move the masses towards its middle."},
      {.rule = {"simulate-sinks", FactKind::kSinks, Severity::kError},
       .message = "sinks {value_mm:.3g} mm into the ground (limit {limit_mm:.3g} mm)",
       .summary = "the model sinks into the ground",
       .why = "Its contacts are too soft for its weight, so wheels stick and cannot turn.",
       .what_to_do = "Check the mass (kg, not g), and lower the `<cfm>` of the world's "
                     "`<constraints>`; with `--profile gazebo` raise the contact's `<kp>`."},
      {.rule = {"simulate-falls-through", FactKind::kFalls, Severity::kError},
       .message = "falls: nothing of it touches the ground",
       .summary = "nothing holds the model: it falls",
       .why = "No shape of it touches the ground, so it falls for ever.",
       .what_to_do = "Give the links that should touch the ground a collision."},
      {.rule = {"simulate-pushed-over", FactKind::kPushedOver, Severity::kError},
       .message = "a push makes its base lean by {value_deg:.3g}° (limit {limit_deg:.3g}°)",
       .summary = "a push tips the model over",
       .why = "The push is a fifth of the momentum of falling by its own size: a person who bumps "
              "into it.",
       .what_to_do = "Lower the center of mass, or widen the stance."},
      {.rule = {"simulate-tilts-early", FactKind::kTiltsEarly, Severity::kError},
       .message = "tips at {value_percent:.3g} % of the slope that its stance allows (at least "
                  "{limit_percent:.3g} % is expected)",
       .summary = "the model tips at a smaller slope than its support predicts",
       .why = "On a table that tilts it falls before its center of mass has passed the edge of its "
              "support: some part of it swings, rolls or slides down first.",
       .what_to_do = "Lower the center of mass, widen the stance, and look for parts that swing."},
  };
  return kRows;
}

}  // namespace rigor::rules::simulation
