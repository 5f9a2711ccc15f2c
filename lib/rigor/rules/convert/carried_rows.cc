// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What rides along: it is carried for some consumers, or lost.

#include <span>

#include <rigor/rules/convert/rows.h>

namespace rigor::rules::conversion {

using convert::NoteKind;

std::span<const Row> carried_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"convert-sensor", NoteKind::kSensor, Severity::kInfo},
       .message = "the sensor {whereabouts}",
       .summary = "a sensor is for Gazebo only",
       .why = "URDF has no sensors. A `<gazebo>` block carries the sensor as it is, which Gazebo "
              "reads; all else sees none.",
       .what_to_do = "Nothing for Gazebo; describe it to other tools in their own way."},
      {.rule = {"convert-light", NoteKind::kLight, Severity::kInfo, Formats::kSdf},
       .message = "the light {whereabouts}",
       .summary = "a light is for Gazebo only",
       .why = "URDF has no lights. A `<gazebo>` block carries the light of a link as it is, which "
              "Gazebo reads; all else sees none.",
       .what_to_do = "Nothing for Gazebo; put the light into the world of another simulator."},
      {.rule = {"convert-plugin", NoteKind::kPlugin, Severity::kInfo},
       .message = "the plugin {whereabouts}",
       .summary = "a plugin is for Gazebo only",
       .why = "A `<gazebo>` block carries the plugin as it is. The names of links and joints in it "
              "are the source's.",
       .what_to_do = "Look at the names in it when links or joints were renamed."},
      {.rule = {"convert-plugin-reference", NoteKind::kPluginReference, Severity::kInfo},
       .message = "{written} of a plugin becomes {instead}",
       .summary = "a plugin refers to what the result has",
       .why = "A plugin names links and joints, and gives places in the frame of a link. Where "
              "the result has another name, or the frame is elsewhere, its parameters are written "
              "anew.",
       .what_to_do = "Nothing: the plugin does the same."},
      {.rule = {"convert-plugin-frame", NoteKind::kPluginFrame, Severity::kWarning},
       .message =
           "{written} of a plugin stays as it is, but the frame of link {instead} is not the "
           "source's",
       .summary = "a plugin may speak in a frame that moved",
       .why =
           "In URDF a link's frame is at its joint, and a link that is lumped has the frame of the "
           "link that holds it. Where a plugin names such a link, as text or as an attribute, its "
           "places and directions in the frame of the link then mean others, unless they are what "
           "rigor knows and rewrites: LiftDrag's cp, forward and upward, the center_of_volume of "
           "Buoyancy, xyzOffset and rpyOffset.",
       .what_to_do = "Move the numbers into the new frame, or put the link's frame at its joint."},
      {.rule = {"convert-safety", NoteKind::kSafety, Severity::kWarning, Formats::kUrdf},
       .message = "the safety controller ({written}) is lost: SDF has none",
       .summary = "a safety controller is lost",
       .why = "SDF has no soft limits of a joint: what kept the controller from running into the "
              "stops is gone.",
       .what_to_do = "Give the soft limits to the controller."},
      {.rule = {"convert-calibration", NoteKind::kCalibration, Severity::kInfo, Formats::kUrdf},
       .message = "the calibration is lost: SDF has none",
       .summary = "a joint's calibration is lost",
       .why = "SDF has no reference positions of a joint.",
       .what_to_do = "Give them to the driver."},
      {.rule = {"convert-transmission", NoteKind::kTransmission, Severity::kWarning,
                Formats::kUrdf},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "transmission {written} is lost: SDF has none"
                                         : "transmission {written} {instead}";
           },
       .summary = "a transmission, or a part of one, is lost",
       .why = "SDF has no transmissions: ros_control reads them from the robot description, which "
              "stays URDF. `--control` writes the position, velocity and effort interfaces of "
              "joints that move, and nothing else; Gazebo Sim has one of them for each joint.",
       .what_to_do =
           "Keep the URDF as the robot description, or choose `--control ros2_control` or "
           "`--control gz`."},
      {.rule = {"convert-ros2-control", NoteKind::kRos2Control, Severity::kWarning, Formats::kUrdf},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "ros2_control {written} is lost: SDF has none"
                                         : "ros2_control {written} {instead}";
           },
       .summary = "a ros2_control block, or a part of one, is lost",
       .why = "SDF has no hardware description: ros2_control reads it from the robot description, "
              "which stays URDF. `--control gz` writes one position, velocity or effort interface "
              "for each joint that moves, and nothing else.",
       .what_to_do = "Keep the URDF as the robot description."},
      {.rule = {"convert-control", NoteKind::kControl, Severity::kInfo, Formats::kUrdf},
       .message = "{written} becomes {instead}",
       .summary = "control is written for another simulator",
       .why = "Gazebo Sim reads neither transmissions nor the plugins of Gazebo classic: what they "
              "say of joints is written as its own plugins, or as ros2_control.",
       .what_to_do = "Check the controllers; `--control keep` leaves the plugins as they are."},
      {.rule = {"convert-block-reference", NoteKind::kBlockReference, Severity::kWarning,
                Formats::kUrdf},
       .message = "the gazebo block of {written} is lost: the robot has nothing of that name",
       .summary = "a <gazebo> block refers to nothing",
       .why = "Its reference names neither a link nor a joint: Gazebo ignores the block silently, "
              "so its content is lost.",
       .what_to_do = "Put the name right."},
      {.rule = {"convert-block-without-collision", NoteKind::kBlockWithoutCollision,
                Severity::kWarning, Formats::kUrdf},
       .message = "{written} of a link without collision is lost",
       .summary = "friction of a link that collides with nothing",
       .why = "Friction and contact belong to collisions in SDF; the link has none, so there is "
              "nowhere to write them.",
       .what_to_do = "Give the link a collision, or remove the block."},
      {.rule = {"convert-comment", NoteKind::kComment, Severity::kInfo},
       .message = "a comment is lost: the element after it is not in the result",
       .summary = "a comment could not be carried",
       .why = "A comment goes with the link or joint that follows it, and that element is not in "
              "the result.",
       .what_to_do = "Check whether the result needs the comment."},
      {.rule = {"convert-not-carried", NoteKind::kUnknown, Severity::kWarning},
       .message = "{written} is not in the result",
       .summary = "an element that the conversion has no rule for",
       .why = "What the conversion has no rule for is lost: the result does not have it.",
       .what_to_do = "Look whether the result needs it."},
      {.rule = {"convert-idle", NoteKind::kIdle, Severity::kInfo},
       .message = "{written}: no reader uses it, so the result does not have it",
       .summary = "something without effect is not carried",
       .why = "No reader uses the axis of a fixed joint or the color of a collision: the robot is "
              "the same without it.",
       .what_to_do = "Nothing; or remove it from the source."},
  };
  return kRows;
}

}  // namespace rigor::rules::conversion
