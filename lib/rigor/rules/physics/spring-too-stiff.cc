// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::spring_too_stiff {

// m or rad: what a spring gives way under the weight of the whole model, at a lever of a meter. That of a car
// gives way by decimeters, a bushing by tenths of a millimeter.
constexpr double kRigid = 1e-5;

constexpr double kGravity = 9.81;  // m/s²

double weight_of(const model::Model& model, const model::Root& root) {
  double mass = 0;
  for (const auto id : model.links) mass += root[id].inertial.mass.value;
  return kGravity * mass;
}

void check(const model::Joint& joint, Context& context) {
  if (!has_axis(joint.type) || !joint.model) return;
  for (const model::Axis& axis : joint.axes) {
    const double stiffness = axis.spring_stiffness.value;
    if (!axis.spring_stiffness.written || !(stiffness > 0)) continue;
    const double weight = weight_of(context.root()[joint.model], context.root());
    if (!(weight > 0) || weight / stiffness > kRigid) continue;
    const bool slides = joint.type == model::JointType::kPrismatic;
    context.report(
        {.where = axis.spring_stiffness.span,
         .message = fmt::format("a spring of {:.4g} {} gives way by {:.2g} {} under the whole "
                                "model's weight of {:.3g} N: the joint cannot move",
                                stiffness, slides ? "N/m" : "N·m/rad", weight / stiffness,
                                position_unit(joint.type), weight),
         .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "spring-too-stiff",
      .severity = Severity::kWarning,
      .summary = "a joint's spring is so stiff that nothing moves the joint",
      .why = "Gazebo holds the joint at the spring's reference: a suspension does not absorb a "
             "bump, and at steps of a millisecond the spring may ring until the model is thrown "
             "about. Under the weight of the whole model, at a lever of a meter where the joint "
             "turns, the spring gives way by less than a hundredth of a millimeter or milliradian.",
      .what_to_do = "Write the stiffness in N/m (N·m/rad of a joint that turns), or make the joint "
                    "fixed if it is to stand still.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::spring_too_stiff
