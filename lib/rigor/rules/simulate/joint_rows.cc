// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What joints do.

#include <span>

#include <rigor/rules/simulate/rows.h>

namespace rigor::rules::simulation {

using simulate::FactKind;

std::span<const Row> joint_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"simulate-joint-pulled-apart", FactKind::kAnchorError, Severity::kError},
       .message = "has its two sides {value_mm:.3g} mm apart (limit {limit_mm:.3g} mm)",
       .summary = "a joint is pulled apart",
       .why = "The two sides of the joint separate: the load or the ratio of masses is more than "
              "the solver can hold together, or a closed loop does not close.",
       .what_to_do = "Keep neighboring masses within a factor of about 50; check that loops close "
                     "at the start; use a smaller time step."},
      {.rule = {"simulate-limit-violated", FactKind::kLimitViolated, Severity::kError},
       .message = "goes {value:.3g} {unit} beyond its limit (allowed {limit:.3g})",
       .summary = "a joint goes beyond its limit",
       .why = "The stop gives way, or the joint begins outside its limits and is thrown back.",
       .what_to_do = "Put the start inside the limits; check the load that the stop must bear."},
      {.rule = {"simulate-joint-jitters", FactKind::kJointJitters, Severity::kError},
       .message = "jitters with {value:.3g} {unit}/s above 20 Hz (limit {limit:.3g})",
       .summary = "a joint jitters",
       .why = "Its velocity changes faster than any command: a controller or spring that is too "
              "stiff for the inertia and the time step, or collisions that fight.",
       .what_to_do =
           "Give the link its true inertia, lower gains or stiffness, or use a smaller time step."},
      {.rule = {"simulate-control-too-stiff", FactKind::kStiffControl, Severity::kError},
       .message = "has a damping times time step of {value:.3g} times the inertia that it acts on "
                  "(limit {limit:.3g})",
       .summary = "damping or a gain is too large for the inertia and the time step",
       .why = "An explicit controller is stable only while d·h/I stays below 2: beyond, each step "
              "overshoots the one before. This is arithmetic and was found before the run.",
       .what_to_do = "Lower the gain or damping, give the link its true inertia, or use a smaller "
                     "time step."},
      {.rule = {"simulate-self-collides", FactKind::kSelfCollides, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name.empty()
                        ? "collides with another link of the model by {value_mm:.3g} mm"
                        : "collides with {name} by {value_mm:.3g} mm";
           },
       .summary = "links of the model collide with each other",
       .why =
           "They should pass each other, or their collision shapes are larger than what is drawn.",
       .what_to_do = "Make the collisions smaller, or limit the joint to where they do not meet."},
      {.rule = {"simulate-joint-does-not-reach", FactKind::kJointShort, Severity::kError},
       .message = "does not reach {value_percent:.3g} % of its range (limit {limit_percent:.3g} %)",
       .summary = "a joint does not reach its limits",
       .why = "Something is in the way: the ground, another link, or the other joints of a closed "
              "loop.",
       .what_to_do = "Clear the way, or set the limit to what the joint can reach."},
      {.rule = {"simulate-joint-overloaded", FactKind::kJointOverloaded, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             if (fact.name == "effort limit of 0")
               return "has an effort limit of 0: no motor turns its wheel";
             if (fact.name == "velocity limit of 0")
               return "has a velocity limit of 0: its wheel does not turn";
             if (fact.name == "drive.reached")
               return "rolls its wheel by {value_percent:.3g} % of the command, the least of all "
                      "wheels (at least {limit_percent:.3g} % is expected)";
             if (fact.name == "joint.reach")
               return "is at its effort limit and does not reach {value_percent:.3g} % of its "
                      "range "
                      "(limit {limit_percent:.3g} %)";
             if (fact.name == "hold.error")
               return "is at its effort limit and {value:.3g} {unit} off its position (limit "
                      "{limit:.3g})";
             return "needs {value_percent:.3g} % of its effort limit (limit {limit_percent:.3g} %)";
           },
       .summary = "a joint needs all the effort that its limit allows",
       .why = "The joint follows its commands late or not at all.",
       .what_to_do =
           "Raise `<effort>` to what the actuator can give, or make what it carries lighter."},
      {.rule = {"simulate-no-motor", FactKind::kNoMotor, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.value > 1 ? "no motor holds {name}: their effort limits are 0"
                                   : "no motor holds {name}: its effort limit is 0";
           },
       .summary = "the effort limits of all joints are 0",
       .why =
           "Exporters write an effort of 0 for \"not known\"; simulators and controllers take it "
           "for a motor that gives nothing, and what the joints carry drops. The model was "
           "simulated as if motors without a limit held them.",
       .what_to_do = "Write the effort of each joint's actuator, and its velocity."},
      {.rule = {"simulate-does-not-hold", FactKind::kDoesNotHold, Severity::kError},
       .message = "is {value:.3g} {unit} off the position that it is to hold (limit {limit:.3g})",
       .summary = "the joints do not hold their position",
       .why = "With a controller on each joint the pose is off or swings: the joint begins outside "
              "its limits, something pushes it, or it cannot be controlled at this time step.",
       .what_to_do = "Put the start inside the limits, give the links their true inertia, or use a "
                     "smaller time step."},
  };
  return kRows;
}

}  // namespace rigor::rules::simulation
