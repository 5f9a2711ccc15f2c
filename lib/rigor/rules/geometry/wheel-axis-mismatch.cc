// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstdint>
#include <numbers>
#include <variant>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::wheel_axis_mismatch {

using model::Vector3;

// 18°: no camber or toe is larger.
constexpr double kAlong = 0.95;

// A disk whose middle is farther from the axis, as a share of its radius, swings rather than rolls.
constexpr double kOffAxis = 0.2;

bool turns_round(const model::Joint& joint) {
  if (joint.type == model::JointType::kContinuous) return true;
  if (joint.type != model::JointType::kRevolute) return false;
  const model::Axis& axis = joint.axes.front();
  if (!axis.lower.written || !axis.upper.written) return true;
  // An arm's wrist may turn twice round; what rolls has no limits, or thousands of turns.
  constexpr double kFewTurns = 10 * 2 * std::numbers::pi;
  return axis.upper.value - axis.lower.value > kFewTurns;
}

/// The link's only collision, when that is a disk.
const model::Collision* disk_of(const model::Link& link, const model::Root& root) {
  if (link.collisions.size() != 1) return nullptr;
  const model::Collision& collision = root[link.collisions.front()];
  const auto* cylinder = std::get_if<model::Cylinder>(&collision.geometry.shape);
  if (cylinder == nullptr || !cylinder->radius.written || !cylinder->length.written) return nullptr;
  if (!(cylinder->length.value < 2 * cylinder->radius.value)) return nullptr;
  return &collision;
}

void check(const model::Joint& joint, Context& context) {
  if (joint.axes.empty() || !joint.axes.front().xyz.written || !turns_round(joint)) return;
  const model::Root& root = context.root();
  const model::Frames& frames = context.frames();
  const model::Id<model::Joint> id{static_cast<std::uint32_t>(&joint - root.joints.data())};
  const auto child = frames.ends(id).child;
  const model::Collision* disk = child ? disk_of(root[child], root) : nullptr;
  if (disk == nullptr) return;
  const auto axis = frames.axis(id, 0);
  const auto X_WJ = frames.pose(id);
  const auto X_WD = frames.pose(root[child].collisions.front());
  if (!axis || !X_WJ || !X_WD) return;
  const double cosine = std::abs(dot(rotate(X_WD->rotation, {0, 0, 1}), *axis));
  if (cosine > kAlong) return;
  const Vector3 arm = X_WD->translation - X_WJ->translation;
  const double off = length(arm - dot(arm, *axis) * *axis);
  if (off > kOffAxis * std::get<model::Cylinder>(disk->geometry.shape).radius.value) return;
  Finding finding{
      .where = joint.axes.front().xyz.span,
      .message = fmt::format(
          "the axis is {:.0f}° off that of the disk which it rotates: the wheel '{}' cannot roll",
          std::acos(cosine) * 180 / std::numbers::pi, root[child].name.value),
      .subject = context.subject(joint)};
  if (root.own(disk->site))
    finding.related = {{disk->geometry.site.name, "the disk: its axis is its z"}};
  context.report(std::move(finding));
}

Rule rule() {
  return {
      .name = "wheel-axis-mismatch",
      .severity = Severity::kWarning,
      .summary = "a wheel's joint axis is not the axis of its shape",
      .why =
          "The wheel tumbles like a coin, or wobbles: it lifts the robot, or does not roll. A "
          "joint "
          "without limits rotates a flat cylinder through its middle, but about another line than "
          "the cylinder's. Mostly the axis is right for another frame: up to SDF 1.4 it is in the "
          "model's, from 1.5 on in the joint's; or the cylinder was turned and the axis not.",
      .what_to_do = "Write the axis along the cylinder's z, in the frame that the axis is in; "
                    "`rigor inspect` prints both in one frame.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::wheel_axis_mismatch
