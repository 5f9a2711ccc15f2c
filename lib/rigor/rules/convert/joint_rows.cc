// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Joints.

#include <span>

#include <rigor/rules/convert/rows.h>

namespace rigor::rules::conversion {

using convert::NoteKind;

std::span<const Row> joint_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"convert-joint-type", NoteKind::kJointType, Severity::kError},
       .message = "{target} has no {written} joint; with --allow-loss it becomes {instead}",
       .summary = "the target has no joint of this type: others are substituted",
       .why = "URDF knows fixed, revolute, continuous and prismatic joints (and floating and "
              "planar ones, which most consumers leave out). A universal joint is exactly two "
              "revolute ones with a link of next to no mass between; other substitutes come near. "
              "Consumers see other joints by other names.",
       .what_to_do = "Check the substitute, then accept it with `--allow-loss`."},
      {.rule = {"convert-joint-type-lost", NoteKind::kJointTypeLost, Severity::kError},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty()
                        ? "{target} has no {written} joint, and nothing can replace it"
                        : "{target} has no {written} joint, and nothing can replace it: {instead}";
           },
       .summary = "the target has no such joint, and nothing replaces it",
       .why = "A joint that cannot be converted is omitted or welded: the mechanism moves "
              "differently.",
       .what_to_do = "Rebuild it from joints that both formats have."},
      {.rule = {"convert-joint-dialect", NoteKind::kJointDialect, Severity::kWarning,
                Formats::kUrdf},
       .message = "a {written} joint is Bullet's own: it becomes {instead}",
       .summary = "a joint type that only Bullet's URDF has",
       .why =
           "URDF has no spherical joint and urdfdom rejects it; Bullet reads it, and SDF and MJCF "
           "have the same joint under the name ball.",
       .what_to_do = "Nothing, where the robot is for Bullet."},
      {.rule = {"convert-continuous", NoteKind::kContinuous, Severity::kInfo},
       .message = "revolute without limits: continuous in URDF",
       .summary = "a revolute joint without limits is a continuous one",
       .why = "SDF and URDF express the same in different ways.",
       .what_to_do = "Nothing: the joint is the same."},
      {.rule = {"convert-limit-unlimited", NoteKind::kLimitStandIn, Severity::kWarning},
       .message = "no limit ({written}): {instead} is used",
       .summary = "a finite number is used as \"unlimited\"",
       .why = "URDF wants both limits of a prismatic or half-limited joint, and urdfdom rejects "
              "`inf`. The number is far beyond what any robot reaches, but planners see a limit.",
       .what_to_do = "Write the limit that the joint really has."},
      {.rule = {"convert-effort-unlimited", NoteKind::kEffortStandIn, Severity::kInfo},
       .message = "effort has no limit ({written}): {instead} is written",
       .summary = "a finite number is used as unlimited effort",
       .why = "URDF demands an effort, urdfdom rejects `inf`, and 0 would mean to controllers that "
              "the joint cannot push.",
       .what_to_do = "Write the effort that the actuator really has."},
      {.rule = {"convert-velocity-unlimited", NoteKind::kVelocityStandIn, Severity::kInfo},
       .message = "velocity has no limit ({written}): {instead} is written",
       .summary = "a finite number is used as unlimited velocity",
       .why = "URDF demands a velocity, urdfdom rejects `inf`, and 0 would mean to planners that "
              "the joint cannot move.",
       .what_to_do = "Write the velocity that the actuator really reaches."},
      {.rule = {"convert-limit-inverted", NoteKind::kLimitInverted, Severity::kError},
       .message = "limits {written}: the lower one is above the upper one",
       .summary = "the lower limit is above the upper one",
       .why = "No position is allowed, and consumers differ: some swap the limits, some freeze the "
              "joint. No conversion of it is right.",
       .what_to_do = "Swap the limits."},
      {.rule = {"convert-spring", NoteKind::kSpring, Severity::kWarning},
       .message = "the joint's spring ({written}) {whereabouts}",
       .summary = "a joint's spring is not in the robot",
       .why = "URDF has no springs. Gazebo reads them from a `<gazebo>` block; whatever else reads "
              "the file sees a joint that swings freely.",
       .what_to_do = "Give the spring to the simulator or the controller."},
      {.rule = {"convert-stiffness", NoteKind::kStiffness, Severity::kWarning, Formats::kSdf},
       .message = "{written} is lost: URDF has hard limits only",
       .summary = "how stiff a joint's stops are is not in the robot",
       .why = "URDF's limits are hard: it has no stiffness and no dissipation of a stop.",
       .what_to_do = "Set them in the simulator where they matter."},
      {.rule = {"convert-axis-unit", NoteKind::kAxisUnit, Severity::kInfo},
       .message = "axis {written} is written as a unit vector",
       .summary = "an axis was made a unit vector",
       .why = "Gazebo normalizes axes; some readers of URDF do not, and would move a prismatic "
              "joint twice as far along an axis of length 2.",
       .what_to_do = "Nothing: the axis is the same."},
      {.rule = {"convert-axis-zero", NoteKind::kAxisZero, Severity::kError},
       .message =
           [](const convert::Note& note) {
             return note.written.empty() ? "the axis has no direction"
                                         : "the axis {written} has no direction";
           },
       .summary = "an axis has no direction",
       .why = "A zero axis has no direction: consumers reject it, or use a default axis.",
       .what_to_do = "Write the direction of the axis."},
      {.rule = {"convert-second-axis", NoteKind::kSecondAxis, Severity::kWarning, Formats::kSdf},
       .message = "a second axis on a joint of one degree of freedom is left out",
       .summary = "a second axis on a joint that has one",
       .why = "A revolute or prismatic joint moves about or along `<axis>`; SDF readers ignore "
              "`<axis2>`, and so does the conversion.",
       .what_to_do = "Take it away, or make the joint a universal one."},
      {.rule = {"convert-mimic-reference", NoteKind::kMimicReference, Severity::kInfo,
                Formats::kSdf},
       .message = "reference {written} is folded into the offset: {instead}",
       .summary = "a mimic's reference was folded into its offset",
       .why = "SDF: follower = multiplier · (leader - reference) + offset. URDF has no reference: "
              "offset - multiplier · reference gives the same.",
       .what_to_do = "Nothing: the joint is the same."},
      {.rule = {"convert-mimic-lost", NoteKind::kMimicLost, Severity::kWarning},
       .message = "the joint no longer follows {written}: {instead}",
       .summary = "a joint that followed another moves on its own",
       .why = "The leader is missing, has two axes, or the target's version has no mimic joints. A "
              "finger that followed its neighbor now moves freely.",
       .what_to_do =
           "Follow in the controller, or choose a version that has mimic joints: SDF 1.11."},
      {.rule = {"convert-mimic-chain", NoteKind::kMimicChain, Severity::kInfo, Formats::kSdf},
       .message = "{written} is no leader but follows, too: the joint follows {instead} now",
       .summary = "a joint that followed a follower follows the leader of both",
       .why = "Most consumers of URDF follow one leader only: a follower of a follower does not "
              "move. Combined multipliers and offsets give the same motion.",
       .what_to_do = "Nothing: the joint moves the same."},
      {.rule = {"convert-gimbal", NoteKind::kGimbal, Severity::kInfo},
       .message = "pitch is ±90°: the same rotation is written as {instead}",
       .summary = "at a pitch of 90° roll and yaw are one turn",
       .why = "Roll-pitch-yaw angles are not unique there. Roll is written as 0 and yaw takes the "
              "whole turn: the rotation is the same to the last digits.",
       .what_to_do = "Nothing: the rotation is the same."},
      {.rule = {"convert-joint-physics", NoteKind::kPhysics, Severity::kWarning, Formats::kSdf},
       .message = "{written} is lost: URDF has no word for it",
       .summary = "solver parameters of a joint are not in the robot",
       .why =
           "URDF has no solver parameters of a joint, and Gazebo's blocks have only some of them.",
       .what_to_do = "Set them in the simulator where they matter."},
  };
  return kRows;
}

}  // namespace rigor::rules::conversion
