// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/core.h>

#include <rigor/rules/kinematics/gravity_load.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::dynamics_exceed_effort {

// rad/s or m/s: 6° or 10 cm in a minute and a half.
constexpr double kSlowest = 1e-3;

// Where no effort limit says what the motor can: as many times the weight that it moves.
constexpr double kStrongMotor = 100;

// N·m·s/rad, N·m (N·s/m, N): no smaller number stops a joint whose effort is unlimited.
constexpr double kLarge = 1e4;

// Of the velocity limit: motor and gear were not made for it.
constexpr double kShareOfVelocity = 0.01;

// rad/s or m/s; a larger limit represents none.
constexpr double kFast = 20;

double slowest(double velocity) {
  return velocity < kFast ? std::max(kSlowest, kShareOfVelocity * velocity) : kSlowest;
}

void check(const model::Root& root, Context& context) {
  std::optional<GravityLoads> loads;
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const model::Joint& joint = root.joints[i];
    if (!root.own(joint.site) || !has_axis(joint.type) || joint.axes.empty()) continue;
    const model::Axis& axis = joint.axes.front();
    const bool damped = axis.damping.written && axis.damping.value > 0;
    const bool rubs = axis.friction.written && axis.friction.value > 0;
    if (!damped && !rubs) continue;
    double effort = effort_limit(root, joint, axis);
    if (effort == 0) continue;  // effort-zero reports it
    bool limited = std::isfinite(effort);
    // An effort limit of 1000 at a wheel of a kilogram is a placeholder, and drives nothing.
    if (std::max(axis.damping.value, axis.friction.value) >= kLarge && limited) {
      if (!loads) loads.emplace(context);
      if (const auto load = loads->most({i})) {
        const double strong = kStrongMotor * std::max(*load, 0.01);
        limited = effort <= strong;
        effort = std::min(effort, strong);
      }
    } else if (!limited) {
      if (std::max(axis.damping.value, axis.friction.value) < kLarge) continue;
      if (!loads) loads.emplace(context);
      const auto load = loads->most({i});
      if (!load) continue;
      effort = kStrongMotor * std::max(*load, 0.01);
    }
    const char* unit = effort_unit(joint.type);
    const auto against =
        limited ? fmt::format("the effort limit of {:.4g} {}", effort, unit)
                : fmt::format("a hundred times the weight behind it ({:.3g} {})", effort, unit);
    if (rubs && (limited || axis.friction.value >= kLarge) && axis.friction.value > effort) {
      context.report(
          {.where = axis.friction.span,
           .message = fmt::format("a friction of {:.6g} {} is above {}: nothing moves the joint",
                                  axis.friction.value, unit, against),
           .subject = context.subject(joint)});
    }
    const double speed = damped ? effort / axis.damping.value : 1;
    if (speed < slowest(velocity_limit(root, joint, axis)) &&
        (limited || axis.damping.value >= kLarge)) {
      context.report(
          {.where = axis.damping.span,
           .message = fmt::format("a damping of {:.6g} {}·s/{} lets {} move the joint at {:.2g} "
                                  "{}/s at most",
                                  axis.damping.value, unit, position_unit(joint.type), against,
                                  speed, position_unit(joint.type)),
           .subject = context.subject(joint)});
    }
  }
}

Rule rule() {
  return {
      .name = "dynamics-exceed-effort",
      .severity = Severity::kWarning,
      .summary = "a joint's damping or friction lets nothing move it",
      .why = "The joint stays where it is, whatever its controller commands: static friction "
             "above the effort limit is never overcome, and damping takes the whole effort at a "
             "hundredth of the velocity limit, or at a millimeter or milliradian per second.",
      .what_to_do = "Write the damping in N·m·s/rad and the friction in N·m (N·s/m and N of a "
                    "prismatic joint). Of a joint that is to stand still, make the type fixed.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::dynamics_exceed_effort
