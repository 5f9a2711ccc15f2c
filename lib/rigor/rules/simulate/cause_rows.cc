// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What in the model explains what a run shows.

#include <span>

#include <rigor/rules/simulate/rows.h>

namespace rigor::rules::simulation {

using simulate::FactKind;

std::span<const Row> cause_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"simulate-cause-inertia", FactKind::kCauseInertia, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.value >= 1 ? "has {value:.4g} times the inertia of its shape"
                                    : "has 1/{inverse:.4g} of the inertia of its shape";
           },
       .help = "run `rigor inertia MODEL --write`",
       .summary = "a link's inertia is not that of its shapes",
       .why = "A wheel with 200 times its inertia rotates the robot instead of itself; one with a "
              "thousandth of it spins up at a touch.",
       .what_to_do = "Run `rigor inertia MODEL --write`."},
      {.rule = {"simulate-cause-default-inertia", FactKind::kCauseDefaultInertia,
                Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.value > 0 ? "has no inertial, so it gets 1 kg and 1 kg·m²: {value:.3g} "
                                     "times the inertia of its shape"
                                   : "has no inertial, so it gets 1 kg and 1 kg·m²";
           },
       .help = "run `rigor inertia MODEL --write`",
       .summary = "a link has the default inertia: 1 kg and 1 kg·m²",
       .why = "Nothing was written, so the simulator takes a body of 1 kg whose moments are those "
              "of a ball three meters wide.",
       .what_to_do = "Run `rigor inertia MODEL --write`."},
      {.rule = {"simulate-cause-mass-ratio", FactKind::kCauseMassRatio, Severity::kWarning},
       .message = "a joint connects it to {name}, which is {value:.3g} times as heavy",
       .help = "keep neighboring masses within a factor of about 50",
       .summary = "large mass ratio across a joint",
       .why =
           "Iterative solvers need about as many iterations as the ratio of masses across a joint.",
       .what_to_do = "Keep the ratio within about 50: make light links heavier or join them to "
                     "their neighbors."},
      {.rule = {"simulate-cause-wheel-off-center", FactKind::kCauseWheelOffCentre,
                Severity::kWarning},
       .message = "its wheel is {value_mm:.3g} mm off the joint's axis",
       .help = "put the wheel's collision on the axis",
       .summary = "a wheel's shape is not on its axis",
       .why = "It rolls like an egg: the robot bounces, and its speed varies within each turn.",
       .what_to_do =
           "Move the collision or the joint so that the axis goes through the wheel's middle."},
      {.rule = {"simulate-cause-wheel-axis", FactKind::kCauseWheelAxis, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "reversed" ? "its axis points the other way: a positive velocity "
                                              "rolls the wheel backwards"
                                            : "its axis is {value_deg:.3g}° off the wheel's own";
           },
       .help = "make the joint's axis that of the wheel",
       .summary = "a wheel's joint axis is not the wheel's own",
       .why = "The wheel wobbles, drags to the side, or rotates against the other one.",
       .what_to_do =
           "Make the joint's axis that of the cylinder, and the same way round on both sides."},
      {.rule = {"simulate-cause-caster-friction", FactKind::kCauseCasterFriction,
                Severity::kWarning},
       .message = "it is dragged over the ground with a friction of {value:.3g}",
       .help = "set its mu and mu2 to 0",
       .summary = "a caster that cannot turn has friction",
       .why = "A sphere in place of a caster is dragged along: the robot cannot turn.",
       .what_to_do = "Set mu and mu2 of the caster's surface to 0."},
      {.rule = {"simulate-cause-top-heavy", FactKind::kCauseTopHeavy, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.value > 0 ? "a slope of {value_deg:.3g}° tips it over"
                                   : "its center of mass is not above its support";
           },
       .help = "lower the center of mass or widen the stance",
       .summary = "the center of mass is high above a narrow stance",
       .why = "The slope that tips it is the ratio of the stance to the height.",
       .what_to_do = "Lower the center of mass, or widen the stance."},
      {.rule = {"simulate-cause-mesh-wheel", FactKind::kCauseMeshWheel, Severity::kWarning},
       .message = "the wheel collides as a mesh with flat sides",
       .help = "make its collision a cylinder",
       .summary = "a wheel collides as a mesh",
       .why =
           "A wheel of flat sides bounces and slips: 3 % of the way with 32 sides, 16 % with 16.",
       .what_to_do =
           "Make its collision a cylinder: `rigor mesh-check FILE --fit cylinder` gives its size."},
      {.rule = {"simulate-cause-start-outside-limits", FactKind::kCauseStartOutsideLimits,
                Severity::kWarning},
       .message = "begins {value:.3g} {unit} outside its limits",
       .help = "shift the limits so that they hold zero",
       .summary = "a joint begins outside its limits",
       .why = "All joints begin at zero; limits that leave zero out throw the joint to the nearest "
              "one in the first step.",
       .what_to_do = "Shift the limits and the joint's pose so that zero lies between them."},
      {.rule = {"simulate-cause-no-collision", FactKind::kCauseNoCollision, Severity::kWarning},
       .message = "nothing of it that moves has a collision",
       .help = "give its links some",
       .summary = "nothing of the model collides",
       .why = "It goes through the ground and through everything else.",
       .what_to_do = "Give it a collision."},
      {.rule = {"simulate-cause-effort", FactKind::kCauseEffort, Severity::kWarning},
       .message = "carries {value:.3g} {effort_unit} and may use {limit:.3g} {effort_unit}",
       .help = "raise the effort limit or lighten what it carries",
       .summary = "a joint's effort limit is below what it carries",
       .why = "At its limit the joint cannot hold the weight of its subtree.",
       .what_to_do = "Raise `<effort>`, or make what it carries lighter."},
      {.rule = {"simulate-cause-flag", FactKind::kCauseFlag, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "kinematic" ? "is kinematic: no force moves it"
                    : fact.name == "max_contacts"
                        ? "has a max_contacts of 0: it touches nothing"
                        : "gravity does not act on it, as it does on other links of the model";
           },
       .help = "remove the flag",
       .summary = "forces or gravity do not act on a link",
       .why = "A kinematic link moves only as commanded; one without gravity floats and puts no "
              "weight on the wheels.",
       .what_to_do =
           "Take out `<kinematic>` and `<gravity>false` where they were left by mistake."},
      {.rule = {"simulate-cause-wheel-friction", FactKind::kCauseWheelFriction, Severity::kWarning},
       .message = "the wheel that drives has a friction of only {value:.3g}",
       .help = "raise its mu and mu2",
       .summary = "a wheel that drives has no friction",
       .why = "What it cannot hold on to it cannot push itself along on: the wheel spins, and the "
              "robot stays or turns to its side.",
       .what_to_do = "Set mu and mu2 of the wheel's surface to that of rubber, about 1."},
      {.rule = {"simulate-cause-wheel-radii", FactKind::kCauseWheelRadii, Severity::kWarning},
       .message =
           "its radius is {value:.4g} m, and that of {name} on the same axle is {limit:.4g} m",
       .help = "make both alike",
       .summary = "two wheels of an axle differ in size",
       .why = "Turning alike they roll different ways, so that a robot that is commanded to drive "
              "straight turns; and it leans to one side.",
       .what_to_do = "Give both wheels one radius."},
      {.rule = {"simulate-cause-soft-contact", FactKind::kCauseSoftContact, Severity::kWarning},
       .message = "with its kp the model sinks {value_mm:.3g} mm into the ground where a simulator "
                  "honours it",
       .help = "raise kp or remove it",
       .summary = "a contact is too soft for the weight on it",
       .why = "A simulator that honours `<kp>` lets the model sink by its weight over the "
              "stiffness of its contacts, and wheels stick.",
       .what_to_do = "Raise `<kp>` of the contact, or remove it: the default is as good as rigid."},
      {.rule = {"simulate-cause-mesh-missing", FactKind::kCauseMeshMissing, Severity::kWarning},
       .message = "lacks {value:.0f} of its {limit:.0f} collisions, whose meshes could not be read",
       .help = "put the files where the URIs lead",
       .summary = "a model lacks collisions whose meshes could not be read",
       .why = "How it rests, and what it touches, is unknown without them, so that findings about "
              "that are warnings at most.",
       .what_to_do = "Put the files where the URIs lead; `rigor resolve URI` lists every place "
                     "that was tried."},
  };
  return kRows;
}

}  // namespace rigor::rules::simulation
