// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/core.h>

#include <rigor/rules/kinematics/gravity_load.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::effort_below_gravity_load {

// Below this share of the load the limit is no small motor's, but another number.
constexpr double kFarBelow = 0.3;

// N·m or N: less is lost in friction.
constexpr double kMinLoad = 0.02;

void check(const model::Root& root, Context& context) {
  std::optional<GravityLoads> loads;
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const model::Joint& joint = root.joints[i];
    if (!root.own(joint.site) || !has_axis(joint.type) || joint.axes.empty()) continue;
    const model::Axis& axis = joint.axes.front();
    const double effort = effort_limit(root, joint, axis);
    if (axis.mimic || !(effort > 0) || !std::isfinite(effort)) continue;
    // A stop, a spring or a damper may hold it.
    if (joint.type != model::JointType::kContinuous && axis.lower.written && axis.upper.written &&
        !(axis.lower.value < axis.upper.value))
      continue;
    if (axis.spring_stiffness.written && axis.spring_stiffness.value > 0) continue;
    if (!loads) loads.emplace(context);
    const auto load = loads->most({i});
    if (!load || *load < kMinLoad || effort >= *load) continue;
    const bool far = effort < kFarBelow * *load;
    context.report({.where = axis.effort.span,
                    .message = fmt::format(
                        "the effort limit of {:.4g} {} is below the {:.3g} {} that the weight "
                        "behind the joint makes",
                        effort, effort_unit(joint.type), *load, effort_unit(joint.type)),
                    .subject = context.subject(joint),
                    .severity = far ? Severity::kWarning : Severity::kInfo});
  }
}

Rule rule() {
  return {
      .name = "effort-below-gravity-load",
      .severity = Severity::kWarning,
      .summary = "a joint's effort limit cannot hold the weight behind it",
      .why = "The joint sinks under its own weight, whatever its controller commands: simulators "
             "clamp commands to the limit. Compared is the largest torque of gravity between "
             "the joint's limits while all others are at zero. Above 30 % of it the finding is an "
             "info: such a joint works in a part of its range.",
      .what_to_do = "Write the motor's peak torque behind its gear in N·m, or N for a prismatic "
                    "joint; or correct masses and centers of mass.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::effort_below_gravity_load
