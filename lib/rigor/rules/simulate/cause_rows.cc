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
      {.rule = {"simulate-cause-inertia-not-written", FactKind::kCauseInertiaNotWritten,
                Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.value > 0 ? "has a mass but no `<inertia>`, so it gets 1 kg·m²: "
                                     "{value:.3g} times the inertia of its shape"
                                   : "has a mass but no `<inertia>`, so it gets 1 kg·m²";
           },
       .help = "run `rigor inertia MODEL --write`",
       .summary = "a link has a mass and the default inertia: 1 kg·m²",
       .why = "SDFormat's moments are 1 kg·m² where none are written, whatever the mass and the "
              "size of the link.",
       .what_to_do = "Run `rigor inertia MODEL --write`."},
      {.rule = {"simulate-cause-mass-ratio", FactKind::kCauseMassRatio, Severity::kWarning},
       .message = "is connected by a joint to {name}, which has {value:.3g} times its mass",
       .help = "keep neighboring masses within a factor of about 50",
       .summary = "large mass ratio across a joint",
       .why =
           "Iterative solvers need about as many iterations as the ratio of masses across a joint.",
       .what_to_do = "Keep the ratio within about 50: make light links heavier or join them to "
                     "their neighbors."},
      {.rule = {"simulate-cause-wheel-off-center", FactKind::kCauseWheelOffCenter,
                Severity::kWarning},
       .message = "has an axis that misses the center of the wheel by {value_mm:.3g} mm",
       .help = "put the wheel's collision on the axis",
       .summary = "a wheel's shape is not on its axis",
       .why = "It rolls like an egg: the robot bounces, and its speed varies within each turn.",
       .what_to_do =
           "Move the collision or the joint so that the axis goes through the wheel's middle."},
      {.rule = {"simulate-cause-wheel-axis", FactKind::kCauseWheelAxis, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "reversed"
                        ? "has a reversed axis: a positive velocity rolls the wheel backward"
                        : "has an axis {value_deg:.3g}° off the wheel's axis of symmetry";
           },
       .help = "align the joint's `axis` with the wheel",
       .summary = "a wheel's joint axis is not the wheel's own",
       .why = "The wheel wobbles, drags to the side, or rotates against the other one.",
       .what_to_do =
           "Align the joint's axis with that of the cylinder, with the same sign on both sides."},
      {.rule = {"simulate-cause-caster-friction", FactKind::kCauseCasterFriction,
                Severity::kWarning},
       .message = "slides on the ground with a friction coefficient of {value:.3g}",
       .help = "set its mu and mu2 to 0",
       .summary = "a caster that cannot turn has friction",
       .why = "A sphere in place of a caster is dragged along: the robot cannot turn.",
       .what_to_do = "Set mu and mu2 of the caster's surface to 0."},
      {.rule = {"simulate-cause-top-heavy", FactKind::kCauseTopHeavy, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.value > 0 ? "tips over on a slope of {value_deg:.3g}°"
                                   : "has its center of mass outside its support";
           },
       .help = "lower the center of mass or widen the stance",
       .summary = "the center of mass is high above a narrow stance",
       .why = "The slope that tips it is the ratio of the stance to the height.",
       .what_to_do = "Lower the center of mass, or widen the stance."},
      {.rule = {"simulate-cause-mesh-wheel", FactKind::kCauseMeshWheel, Severity::kWarning},
       .message = "collides as a mesh with flat sides, and is a wheel",
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
       .message = "has no collision on any link that moves",
       .help = "give its links collisions",
       .summary = "nothing of the model collides",
       .why = "It goes through the ground and through everything else.",
       .what_to_do = "Give it a collision."},
      {.rule = {"simulate-cause-effort", FactKind::kCauseEffort, Severity::kWarning},
       .message = "carries a load of {value:.3g} {effort_unit}, above its effort limit of "
                  "{limit:.3g} {effort_unit}",
       .help = "raise the effort limit or lighten what it carries",
       .summary = "a joint's effort limit is below what it carries",
       .why = "At its limit the joint cannot hold the weight of its subtree.",
       .what_to_do = "Raise `<effort>`, or make what it carries lighter."},
      {.rule = {"simulate-cause-flag", FactKind::kCauseFlag, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "kinematic"      ? "is kinematic: no force moves it"
                    : fact.name == "max_contacts" ? "has a max_contacts of 0: nothing touches it"
                    : fact.name == "no gravity"
                        ? "has gravity switched off: it floats where it is"
                        : "has gravity switched off, unlike other links of the model";
           },
       .help = "remove the flag",
       .summary = "forces or gravity do not act on a link",
       .why = "A kinematic link moves only as commanded; one without gravity floats and puts no "
              "weight on the wheels.",
       .what_to_do =
           "Take out `<kinematic>` and `<gravity>false` where they were left by mistake."},
      {.rule = {"simulate-cause-wheel-friction", FactKind::kCauseWheelFriction, Severity::kWarning},
       .message = "has a friction coefficient of only {value:.3g}, and is a driven wheel",
       .help = "raise its mu and mu2",
       .summary = "a wheel that drives has no friction",
       .why = "Without friction the wheel spins, and the robot stays where it is or turns to that "
              "side.",
       .what_to_do = "Set mu and mu2 of the wheel's surface to that of rubber, about 1."},
      {.rule = {"simulate-cause-wheel-radii", FactKind::kCauseWheelRadii, Severity::kWarning},
       .message = "has a radius of {value:.4g} m; {name} on the same axle has {limit:.4g} m",
       .help = "give both wheels the same radius",
       .summary = "two wheels of an axle differ in size",
       .why = "At the same velocity they roll different distances, so that a robot that is "
              "commanded to drive "
              "straight turns; and it leans to one side.",
       .what_to_do = "Give both wheels one radius."},
      {.rule = {"simulate-cause-soft-contact", FactKind::kCauseSoftContact, Severity::kWarning},
       .message =
           "has a kp that lets the model sink {value_mm:.3g} mm into the ground in simulators "
           "that use it",
       .help = "raise kp or remove it",
       .summary = "a contact is too soft for the weight on it",
       .why = "A simulator that uses `<kp>` lets the model sink by its weight over the "
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
      {.rule = {"simulate-cause-mesh-scale", FactKind::kCauseMeshScale, Severity::kError},
       .message = "has a collision mesh {value:.3g} m long, and the inertia of one {limit:.3g} m "
                  "long",
       .help = "set the mesh's `scale` to the unit of its file: 0.001 for millimeters, 0.01 for "
               "centimeters",
       .summary = "a collision mesh is read in the wrong unit",
       .why =
           "The mesh is a hundred times and more as large as its link's inertia allows: its file "
           "is in millimeters or centimeters, and `scale` is missing. The model fails whatever "
           "the simulation shows, since it is not the robot that the file describes.",
       .what_to_do = "Set `scale` of the mesh: 0.001 for millimeters, 0.01 for centimeters. `rigor "
                     "mesh-check FILE` prints its bounds."},
  };
  return kRows;
}

}  // namespace rigor::rules::simulation
