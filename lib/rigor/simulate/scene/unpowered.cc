// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/unpowered.h>

#include <algorithm>
#include <string>
#include <utility>

#include <rigor/simulate/joint_load.h>
#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/test/parts.h>

namespace rigor::simulate {
namespace {

/// rad: what is pushed on where it is moved by so much does not stay.
constexpr double kNudge = 0.01;

/// Of what the weight at the end of its arm could be: rounding.
constexpr double kNoLoad = 1e-6;

/// Names beyond are counted.
constexpr std::size_t kNamedJoints = 8;

/// Whether the weight of what it carries moves it away from where it begins.
bool drops(const JointLoads& loads, const SceneJoint& joint) {
  const SceneAxis& axis = joint.axes[0];
  const double nudge = joint.type == model::JointType::kPrismatic ? 0 : kNudge;
  const double least = axis.friction + kNoLoad;
  const bool may_rise = axis.start < axis.upper;
  const bool may_sink = axis.start > axis.lower;
  return (may_rise && loads.gravity_effort(joint, nudge) > least) ||
         (may_sink && loads.gravity_effort(joint, -nudge) < -least);
}

}  // namespace

std::vector<std::uint32_t> unpowered_joints(const Scene& scene, const DriveTrain& wheels) {
  std::vector<std::uint32_t> joints;
  if (!scene.alone) return joints;
  const std::vector<bool> rolling = rolling_joints(scene);
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    if (!can_be_commanded(joint) || joint.child >= scene.bodies.size()) continue;
    if (is_wheel_joint(wheels, j) || rolling[j] || joint.axes[0].spring_stiffness != 0) continue;
    if (!(joint.axes[0].lower < joint.axes[0].upper)) continue;
    if (joint.axes[0].effort > 0) return {};  // what has motors lacks none by mistake
    joints.push_back(j);
  }
  const JointLoads loads(scene);
  const bool any_drops = std::any_of(
      joints.begin(), joints.end(), [&](std::uint32_t j) { return drops(loads, scene.joints[j]); });
  return any_drops ? joints : std::vector<std::uint32_t>{};
}

Scene powered(Scene scene, const std::vector<std::uint32_t>& joints) {
  for (const std::uint32_t j : joints) {
    SceneAxis& axis = scene.joints[j].axes[0];
    axis.effort = kInfinity;
    if (!(axis.velocity > 0)) axis.velocity = kInfinity;
  }
  return scene;
}

Fact about_unpowered(const Scene& scene, const std::vector<std::uint32_t>& joints) {
  const SceneJoint& first = scene.joints[joints.front()];
  Fact fact = about_model(scene, first.model == kWorld ? 0 : first.model);
  fact.kind = FactKind::kNoMotor;
  fact.severe = false;
  fact.value = static_cast<double>(joints.size());
  const Span limit = first.axes[0].limit_where;
  fact.where = limit.nowhere() ? first.where : limit;
  fact.name.clear();
  for (std::size_t i = 0; i < joints.size() && i < kNamedJoints; ++i) {
    const std::string& scoped = scene.joints[joints[i]].name;
    const std::size_t colon = scoped.rfind("::");
    fact.name += (i > 0 ? ", " : "") + scoped.substr(colon == std::string::npos ? 0 : colon + 2);
  }
  if (joints.size() > kNamedJoints) {
    fact.name += " and " + std::to_string(joints.size() - kNamedJoints) + " more";
  }
  return fact;
}

}  // namespace rigor::simulate
