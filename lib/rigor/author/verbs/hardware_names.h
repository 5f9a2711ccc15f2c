// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names of a URDF's hardware, which are neither links nor joints: of `<ros2_control>`, its sensors and GPIOs, of
// transmissions and actuators. controller_manager and ros_control take each once.
//
//   append(edits, renamed_hardware(arm, gripper, {"left_", "gripper_"}, notes));
//
// Private to the room.

#pragma once

#include <string>
#include <vector>

#include <rigor/author/verbs/edited_model.h>
#include <rigor/text/edit.h>

namespace rigor::author {

struct HardwarePrefixes {
  std::string all;    ///< of every name; empty: none
  std::string taken;  ///< else of one that the other model has, too
};

/// Edits of the part's document, for its copy in the model. A note for each name that changes.
std::vector<Edit> renamed_hardware(const EditedModel& model, const EditedModel& part,
                                   const HardwarePrefixes& prefixes,
                                   std::vector<std::string>& notes);

}  // namespace rigor::author
