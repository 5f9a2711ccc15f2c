// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the types of joints can do.

#pragma once

#include <rigor/model/model.h>
#include <rigor/model/motion.h>

namespace rigor::rules {

/// Whether the joint's first axis turns, so that its limits are angles.
inline bool turns(model::JointType type) {
  using model::JointType;
  return type == JointType::kRevolute || type == JointType::kContinuous ||
         type == JointType::kRevolute2 || type == JointType::kUniversal ||
         type == JointType::kGearbox || type == JointType::kScrew;
}

/// Whether the joint moves along or about an axis that has to be given.
inline bool has_axis(model::JointType type) {
  return turns(type) || type == model::JointType::kPrismatic || type == model::JointType::kPlanar;
}

/// "rad" or "m"; "N·m" or "N".
inline const char* position_unit(model::JointType type) { return turns(type) ? "rad" : "m"; }
inline const char* effort_unit(model::JointType type) { return turns(type) ? "N·m" : "N"; }

}  // namespace rigor::rules
