// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/sdformat_robot.h>

namespace rigor::rules::axis_zero {

/// An axis that is no longer is refused by libsdformat, whose limit is in single precision.
constexpr double kNoLength = 1e-6F;

std::string message_about(const model::Vector3& axis) {
  const double length = model::length(axis);
  if (!(length > 0)) return "the axis is 0 0 0: it has no direction";
  return fmt::format("the axis is {:.3g} long, which counts as 0: it has no direction", length);
}

/// Whether the joint is one of the model that libsdformat makes of a URDF.
bool in_sdformat_model(const model::Joint& joint, Context& context) {
  if (!context.is_urdf()) return true;
  const auto& parts = context.sdformat_robot().parts;
  return std::any_of(parts.begin(), parts.end(), [&](const SdformatRobot::Part& part) {
    return part.joint && &context.root()[part.joint] == &joint &&
           part.fate == SdformatRobot::Fate::kLink;
  });
}

void check(const model::Joint& joint, Context& context) {
  // Exporters of URDF write 0 0 0 for fixed joints, and no consumer looks at it.
  if (context.is_urdf() && !has_axis(joint.type)) return;
  for (const model::Axis& axis : joint.axes) {
    if (!axis.xyz.written || model::length(axis.xyz.value) > kNoLength) continue;
    context.report({.where = axis.xyz.span,
                    .message = message_about(axis.xyz.value),
                    .subject = context.subject(joint),
                    .refused = in_sdformat_model(joint, context)});
  }
}

Rule rule() {
  return {
      .name = "axis-zero",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kSays},
      .summary = "a joint axis is the zero vector, or as short as one",
      .why = "libsdformat refuses the model (error 9) when the axis is no longer than 1e-6, and so "
             "do Drake and MuJoCo when it is zero. urdfdom takes it, and what then turns about "
             "nothing depends on the simulator.",
      .what_to_do = "Give the axis a direction, such as 0 0 1.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::axis_zero
