// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a mimic follows, and what the limits of a joint are good for.

#pragma once

#include <cstddef>
#include <string_view>
#include <variant>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/model/motion.h>

namespace rigor::rules {

/// Whether the limits of a joint of this type bound its positions.
inline bool is_limited(model::JointType type) {
  using model::JointType;
  return type == JointType::kRevolute || type == JointType::kPrismatic ||
         type == JointType::kUniversal || type == JointType::kRevolute2 ||
         type == JointType::kScrew || type == JointType::kGearbox;
}

/// Whether an effort or velocity of zero holds the joint, as effort-zero and velocity-zero say.
inline bool is_stuck(const model::Root& root, const model::Joint& joint, const model::Axis& axis) {
  return effort_limit(root, joint, axis) == 0 || velocity_limit(root, joint, axis) == 0;
}

/// How many numbers say where a joint of this type is; none are known of an unknown type.
inline std::size_t degrees_of_freedom(model::JointType type) {
  using model::JointType;
  switch (type) {
    case JointType::kUnknown:
    case JointType::kFixed: return 0;
    case JointType::kRevolute:
    case JointType::kContinuous:
    case JointType::kPrismatic:
    case JointType::kScrew:
    case JointType::kGearbox: return 1;
    case JointType::kUniversal:
    case JointType::kRevolute2: return 2;
    case JointType::kBall:
    case JointType::kPlanar: return 3;
    case JointType::kFloating: return 6;
  }
  return 0;
}

/// The joint of a name in a model, or in one nested in it; none where there is none.
inline model::Id<model::Joint> joint_named(const model::Frames& frames,
                                           model::Id<model::Model> scope, std::string_view name) {
  if (!scope || name.empty()) return {};
  if (const auto joint = frames.names().find_joint(scope, name)) return joint;
  const model::Named named = frames.names().find({scope, {}}, name);
  const auto* joint = std::get_if<model::Id<model::Joint>>(&named);
  return joint == nullptr ? model::Id<model::Joint>{} : *joint;
}

/// The joint that a mimic follows; none where it does not exist, or is the joint itself.
inline model::Id<model::Joint> leader_of(const model::Frames& frames, const model::Joint& joint,
                                         const model::Mimic& mimic) {
  if (mimic.joint.value == joint.name.value) return {};
  return joint_named(frames, joint.model, mimic.joint.value);
}

/// Which axis of its leader a mimic follows.
inline std::size_t leading_axis(const model::Mimic& mimic) {
  return mimic.axis.value == "axis2" ? 1 : 0;
}

}  // namespace rigor::rules
