// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::velocity_looks_like_degrees {

constexpr double kDegree = 57.29577951308232;

// Degrees are written with four digits at most, often rounded to whole ones.
constexpr double kSame = 5e-3;

// rad/s: fast servos of arms and legs turn at 30.
constexpr double kMin = 40;

/// The velocity of another joint of the type that is this one, in radians: a wheel is faster than what tilts.
std::optional<double> twin(const model::Joint& joint, const model::Model& robot,
                           const model::Root& root) {
  const double velocity = joint.axes.front().velocity.value;
  for (const auto id : robot.joints) {
    const model::Joint& other = root[id];
    if (other.type != joint.type || other.axes.empty()) continue;
    const auto& given = other.axes.front().velocity;
    if (given.written && given.value > 0 &&
        std::abs(velocity / kDegree - given.value) < kSame * given.value) {
      return given.value;
    }
  }
  return std::nullopt;
}

void check(const model::Model& robot, Context& context) {
  const model::Root& root = context.root();
  for (const auto id : robot.joints) {
    const model::Joint& joint = root[id];
    if (!root.own(joint.site) || !turns(joint.type) || joint.axes.empty()) continue;
    const auto& velocity = joint.axes.front().velocity;
    if (!velocity.written || !(velocity.value > kMin)) continue;
    const auto meant = twin(joint, robot, root);
    if (!meant) continue;
    context.report(
        {.where = velocity.span,
         .message =
             fmt::format("the velocity {0:.6g} looks like degrees per second: {0:.6g}°/s is the "
                         "{1:.4g} rad/s of other joints",
                         velocity.value, *meant),
         .subject = context.subject(joint),
         .fix = Fix{
             "write rad/s", Applicability::kUnsafe, {{velocity.span, write::joined({*meant})}}}});
  }
}

Rule rule() {
  return {
      .name = "velocity-looks-like-degrees",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a joint's velocity limit is another's in degrees per second",
      .why = "The limit is in rad/s: read so, the joint may turn fifty times faster than its "
             "neighbors, and a trajectory that is timed by it is one that no motor follows. A "
             "velocity is reported when it is that of another joint of the robot, of the same "
             "type, times 180/π.",
      .what_to_do = "Convert it to radians per second.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::velocity_looks_like_degrees
