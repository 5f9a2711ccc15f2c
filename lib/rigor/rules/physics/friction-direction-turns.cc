// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <variant>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::friction_direction_turns {

constexpr double kAligned = 0.9;  // cosine of 26°: a mecanum wheel's rollers stand at 45°
constexpr double kCentred = 0.1;  // of the radius

/// Whether the joint turns a wheel: what turns by less always has the same side on the ground.
bool turns_round(const model::Joint& joint) {
  if (joint.type == model::JointType::kContinuous) return true;
  if (joint.type != model::JointType::kRevolute || joint.axes.empty()) return false;
  const model::Axis& axis = joint.axes.front();
  return !axis.limit_written || axis.upper.value - axis.lower.value >= 2 * std::numbers::pi;
}

/// Whether it is round about the axle: a ball, or a cylinder along it, with its middle on it.
bool is_wheel(const model::Shape& shape, const model::Pose& X_WC, const model::Vector3& axis_W,
              const model::Vector3& p_WJ) {
  const auto* cylinder = std::get_if<model::Cylinder>(&shape);
  const auto* ball = std::get_if<model::Sphere>(&shape);
  if (cylinder == nullptr && ball == nullptr) return false;
  const model::Vector3 z_W = model::rotate(X_WC.rotation, {0, 0, 1});
  if (cylinder != nullptr && std::abs(model::dot(z_W, axis_W)) < kAligned) return false;
  const double radius = cylinder != nullptr ? cylinder->radius.value : ball->radius.value;
  const double off = model::length(model::cross(X_WC.translation - p_WJ, axis_W));
  return off < kCentred * radius;
}

/// Not when none is written, when it stands in a frame of its own, or when both directions are alike.
bool has_direction(const model::Surface& surface) {
  if (!surface.fdir1.written || surface.fdir1_in_frame) return false;
  if (!(model::length(surface.fdir1.value) > 0)) return false;
  return surface.mu.value != surface.mu2.value || surface.slip1.value != surface.slip2.value;
}

void check(const model::Joint& joint, Context& context) {
  if (!turns_round(joint)) return;
  const model::Root& root = context.root();
  const model::Id<model::Joint> id{static_cast<std::uint32_t>(&joint - root.joints.data())};
  const auto wheel = context.frames().ends(id).child;
  if (!wheel || !root.own(root[wheel].site)) return;
  const auto axis_W = context.frames().axis(id, 0);
  const auto X_WJ = context.frames().pose(id);
  if (!axis_W || !X_WJ) return;
  for (const auto collision_id : root[wheel].collisions) {
    const model::Collision& collision = root[collision_id];
    const auto X_WC = context.frames().pose(collision_id);
    if (!X_WC || !is_wheel(collision.geometry.shape, *X_WC, *axis_W, X_WJ->translation)) continue;
    if (!has_direction(collision.surface)) continue;
    const auto& along = collision.surface.fdir1;
    const model::Vector3 along_W = model::rotate(X_WC->rotation, along.value);
    const double aligned = std::abs(model::dot(along_W, *axis_W)) / model::length(along.value);
    if (aligned > kAligned) continue;
    const model::Vector3 axle =
        model::rotate(model::conjugate(X_WC->rotation), *axis_W);  // in the collision's frame
    context.report(
        {.where = along.span,
         .message = fmt::format(
             "the friction direction is {:.0f}° off the axle of '{}': it turns with "
             "the wheel, and points into the ground twice a turn",
             std::acos(std::min(1.0, aligned)) * 180 / std::numbers::pi, joint.name.value),
         .subject = context.subject(collision),
         .related = {{joint.site.name, "turns the wheel"}},
         .help = fmt::format("the axle is {:.3g} {:.3g} {:.3g} in the collision's frame", axle.x,
                             axle.y, axle.z)});
  }
}

Rule rule() {
  return {
      .name = "friction-direction-turns",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary =
          "the friction direction of a wheel is not its axle, so that it turns with the wheel",
      .why = "fdir1 is fixed to the collision, which turns with its link: only a direction along "
             "the axle stays where it is. With another one mu and mu2 change places as the wheel "
             "turns, and the robot pulls to a side or hops.",
      .what_to_do = "Let fdir1 be the axle in the collision's frame, 0 0 1 for a cylinder; mu is "
                    "then the friction sideways, mu2 the one that drives. gz:expressed_in names a "
                    "frame that does not turn.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::friction_direction_turns
