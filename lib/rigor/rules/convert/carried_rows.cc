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
       .summary = "a transmission is lost",
       .why = "SDF has no transmissions: ros_control reads them from the robot description, which "
              "stays URDF.",
       .what_to_do = "Keep the URDF as the robot description."},
      {.rule = {"convert-ros2-control", NoteKind::kRos2Control, Severity::kWarning, Formats::kUrdf},
       .message =
           [](const convert::Note& note) {
             return note.instead.empty() ? "ros2_control {written} is lost: SDF has none"
                                         : "ros2_control {written} {instead}";
           },
       .summary = "a ros2_control block is lost",
       .why = "SDF has no hardware description: ros2_control reads it from the robot description, "
              "which stays URDF.",
       .what_to_do = "Keep the URDF as the robot description."},
      {.rule = {"convert-block-reference", NoteKind::kBlockReference, Severity::kWarning,
                Formats::kUrdf},
       .message = "the gazebo block of {written} is lost: the robot has nothing of that name",
       .summary = "a gazebo block speaks of nothing",
       .why = "Its reference names neither a link nor a joint: Gazebo passes over it without a "
              "word, and so what it says is lost.",
       .what_to_do = "Put the name right."},
      {.rule = {"convert-block-without-collision", NoteKind::kBlockWithoutCollision,
                Severity::kWarning, Formats::kUrdf},
       .message = "{written} of a link without collision is lost",
       .summary = "friction of a link that collides with nothing",
       .why = "Friction and contact belong to collisions in SDF; the link has none, so there is "
              "nowhere to write them.",
       .what_to_do = "Give the link a collision, or take the block away."},
      {.rule = {"convert-comment", NoteKind::kComment, Severity::kInfo},
       .message = "a comment is lost: what it stands before is not in the result",
       .summary = "a comment could not be carried",
       .why = "Comments go with the link or joint that they stand before; what stood there is not "
              "in the result.",
       .what_to_do = "Look whether it says something that the result should say."},
      {.rule = {"convert-not-carried", NoteKind::kUnknown, Severity::kWarning},
       .message = "{written} is not in the result",
       .summary = "an element that the conversion has no rule for",
       .why = "What has no rule is a loss: the result does not say it.",
       .what_to_do = "Look whether the result needs it."},
      {.rule = {"convert-idle", NoteKind::kIdle, Severity::kInfo},
       .message = "{written}: no reader takes it, so the result does not say it",
       .summary = "something without effect is not carried",
       .why = "What a fixed joint says of its axis, or a collision of its colour, no reader takes: "
              "the robot is the same without it.",
       .what_to_do = "Nothing; or take it out of the source."},
  };
  return kRows;
}

}  // namespace rigor::rules::conversion
