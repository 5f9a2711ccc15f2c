// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How a robot drives.

#include <span>

#include <rigor/rules/simulate/rows.h>

namespace rigor::rules::simulation {

using simulate::FactKind;

std::span<const Row> drive_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"simulate-wheels-idle", FactKind::kWheelsMiss, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.value > 0 ? "wheels {name} are {value_mm:.3g} mm above the ground"
                                   : "wheels {name} only turn by {limit_deg:.4g}° between limits";
           },
       .summary = "wheels do not touch the ground, or do not turn on and on",
       .why = "A wheel that hangs in the air, or that a joint with limits stops after a turn, "
              "drives nothing: no test of driving was run with it.",
       .what_to_do = "Lower the wheels or raise what stands on the ground instead; make their "
                     "joints `continuous`."},
      {.rule = {"simulate-drive-slips", FactKind::kDriveSlips, Severity::kError},
       .message = "travels a distance {value_percent:.3g} % off what its wheels roll (limit "
                  "{limit_percent:.3g} %)",
       .summary = "the robot does not travel as far as its wheels roll",
       .why = "Wheels slip, bounce or drag something along: odometry that is computed from them is "
              "wrong by that much.",
       .what_to_do = "Make wheels cylinders or spheres, not meshes; give casters no friction; "
                     "check that driven wheels bear weight and have friction."},
      {.rule = {"simulate-drives-backwards", FactKind::kDriveBackwards, Severity::kError},
       .message = "travels {value:.3g} m forward for each meter that its wheels roll (at least "
                  "{limit:.3g} m is expected)",
       .summary = "the robot does not go ahead when its wheels turn forward",
       .why = "An axis points the wrong way, or the inertias are such that the body rotates "
              "instead of the wheels.",
       .what_to_do = "Reverse the axis; run `rigor inertia MODEL` when inertias are missing."},
      {.rule = {"simulate-drive-drifts", FactKind::kDriveDrifts, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "drive.yaw" ? "turns by {value_deg:.3g}° as it drives straight on "
                                               "(limit {limit_deg:.3g}°)"
                                             : "drifts to the side by {value_percent:.3g} % of the "
                                               "way (limit {limit_percent:.3g} %)";
           },
       .summary = "the robot does not drive straight",
       .why = "Both sides were commanded alike. Radii, friction, masses or axes differ between "
              "left and right.",
       .what_to_do = "Compare the two sides: radius, axis, position of the wheels, masses."},
      {.rule = {"simulate-drive-bounces", FactKind::kDriveBounces, Severity::kError},
       .message = "bounces with {value_mm:.3g} mm/s as it drives (limit {limit_mm:.3g} mm/s)",
       .summary = "the robot bounces as it drives",
       .why = "A wheel is not round about its axis: off center, or a mesh with flat sides.",
       .what_to_do = "Put the wheel's collision on its axis, and make it a cylinder."},
      {.rule = {"simulate-turns-off", FactKind::kTurnOff, Severity::kError},
       .message =
           "turns by an angle {value_percent:.3g} % outside what its wheels' speeds give (limit "
           "{limit_percent:.3g} %)",
       .summary = "the robot does not turn as its wheels do",
       .why = "The turn is outside what the track, plus or minus the width of the wheels, allows: "
              "a caster drags, or wheels slip sideways.",
       .what_to_do =
           "Give casters no friction (mu and mu2 of 0), and check the wheels' positions."},
      {.rule = {"simulate-does-not-brake", FactKind::kDoesNotBrake, Severity::kError},
       .message =
           "keeps {value_percent:.3g} % of its speed one second after its wheels stop (limit "
           "{limit_percent:.3g} %)",
       .summary = "the robot does not stop when its wheels do",
       .why = "It slides or tips over its front wheels.",
       .what_to_do =
           "Check the friction of the wheels, and that the center of mass is not too high."},
  };
  return kRows;
}

}  // namespace rigor::rules::simulation
