// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A motor for each joint with an effort limit, and for each that the source says is driven.

#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include <rigor/convert/mjcf/draft.h>
#include <rigor/model/subject.h>

namespace rigor::convert {
namespace {

/// The share of the velocity limit at which a velocity actuator gives its full effort.
constexpr double kFullEffortShare = 0.1;

/// rad/s, m/s: what a joint without a velocity limit is taken to reach.
constexpr double kSupposedVelocity = 10;

/// N·m, N: what a position or velocity actuator of a joint without an effort limit is designed for.
constexpr double kSupposedEffort = 100;

void set_limits(MjcfElement& element, const std::string& what, double least, double most) {
  element.set(what + "limited", "true");
  element.set(what + "range", mjcf_numbers({least, most}));
}

double finite_or(double value, double otherwise) {
  return std::isfinite(value) ? value : otherwise;
}

MjcfElement motor(const robot::Axis& axis) {
  MjcfElement element{"motor"};
  if (std::isfinite(axis.effort)) set_limits(element, "ctrl", -axis.effort, axis.effort);
  return element;
}

MjcfElement position_actuator(const robot::Axis& axis) {
  MjcfElement element{"position"};
  if (std::isfinite(axis.lower) && std::isfinite(axis.upper) && axis.lower < axis.upper) {
    set_limits(element, "ctrl", axis.lower, axis.upper);
  }
  element.set("kp", mjcf_number(finite_or(axis.effort, kSupposedEffort) / kFullEffortError));
  if (std::isfinite(axis.effort)) set_limits(element, "force", -axis.effort, axis.effort);
  return element;
}

MjcfElement velocity_actuator(const robot::Axis& axis) {
  MjcfElement element{"velocity"};
  const double velocity = finite_or(axis.velocity, kSupposedVelocity);
  if (std::isfinite(axis.velocity) && axis.velocity > 0) {
    set_limits(element, "ctrl", -axis.velocity, axis.velocity);
  }
  const double effort = finite_or(axis.effort, kSupposedEffort);
  element.set("kv", mjcf_number(effort / (kFullEffortShare * (velocity > 0 ? velocity : 1))));
  if (std::isfinite(axis.effort)) set_limits(element, "force", -axis.effort, axis.effort);
  return element;
}

/// Why an axis has no actuator although it has an effort limit; empty where it has one.
std::string_view undriven(const MjcfDraft& draft, const robot::Joint& joint,
                          const robot::Axis& axis) {
  if (axis.follow) return "follows another one";
  if (joint.closes_loop) return "closes a loop";
  if (length(axis.direction) == 0 || axis.lower == axis.upper) return "cannot move";
  if (axis.effort == 0) return "cannot be driven";
  if (draft.options.actuators == MjcfActuators::kNone) return "is not to be driven";
  return {};
}

void tell_effort(MjcfDraft& draft, const robot::Joint& joint, std::size_t k,
                 std::string_view reason) {
  const model::Joint* source = draft.entities.joint(joint.span);
  if (source == nullptr || k >= source->axes.size() || !source->axes[k].effort.written) return;
  const auto& effort = source->axes[k].effort;
  draft.ledger.take(effort, Outcome::kLost);
  draft.ledger.note({.kind = NoteKind::kMjcfEffort,
                     .outcome = Outcome::kLost,
                     .where = effort.span,
                     .subject = model::subject(draft.root(), *source),
                     .written = mjcf_number(effort.value),
                     .instead = std::string(reason)});
}

}  // namespace

void add_mjcf_actuators(MjcfDraft& draft) {
  const MjcfActuators kind = draft.options.actuators;
  std::set<std::string> driven;
  for (const auto& each : draft.root().controlled_joints) driven.insert(each.joint.value);
  const robot::Robot& robot = draft.robot();
  for (std::uint32_t i = 0; i < robot.joints.size(); ++i) {
    const robot::Joint& joint = robot.joints[i];
    if (joint.type == model::JointType::kBall) continue;
    for (std::size_t k = 0; k < joint.axes.size(); ++k) {
      const robot::Axis& axis = joint.axes[k];
      const bool limited = std::isfinite(axis.effort);
      if (const auto reason = undriven(draft, joint, axis); !reason.empty()) {
        if (limited) tell_effort(draft, joint, k, reason);
        continue;
      }
      if (k >= draft.joint_names[i].size()) continue;
      if (!limited && !driven.contains(joint.name)) continue;
      MjcfElement element = kind == MjcfActuators::kMotor      ? motor(axis)
                            : kind == MjcfActuators::kPosition ? position_actuator(axis)
                                                               : velocity_actuator(axis);
      const std::string& name = draft.joint_names[i][k];
      element.attributes.insert(element.attributes.begin(), {{"name", name}, {"joint", name}});
      draft.actuator.add(std::move(element));
    }
  }
}

}  // namespace rigor::convert
