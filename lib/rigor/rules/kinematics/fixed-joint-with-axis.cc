// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>

#include <rigor/robot/assembled/twins.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::fixed_joint_with_axis {

/// Whether something says that it should move: a range, its twin, or a plugin that names it.
bool should_move(const model::Joint& joint, const model::Axis& axis, const Context& context) {
  if (axis.lower.written && axis.lower.value < axis.upper.value) return true;
  const model::Root& root = context.root();
  const auto twins = robot::mirrored_names(joint.name.value, robot::Side::kAcross);
  const auto is_twin = [&](const model::Joint& other) {
    return other.type != model::JointType::kFixed && other.model == joint.model &&
           std::find(twins.begin(), twins.end(), other.name.value) != twins.end();
  };
  const auto names_it = [&](const model::Plugin& plugin) {
    return std::any_of(
        plugin.parameters.begin(), plugin.parameters.end(),
        [&](const model::Parameter& given) { return given.value.value == joint.name.value; });
  };
  return std::any_of(root.joints.begin(), root.joints.end(), is_twin) ||
         std::any_of(root.plugins.begin(), root.plugins.end(), names_it);
}

void check(const model::Joint& joint, Context& context) {
  if (joint.type != model::JointType::kFixed || joint.axes.empty()) return;
  const model::Axis& axis = joint.axes.front();
  if (axis.site.element == joint.site.element) return;  // only a limit, or the like
  // Exporters of URDF write 0 0 0 there, and mean none; of SDF axis-zero speaks.
  if (axis.xyz.value == model::Vector3{}) return;
  context.report(
      {.where = axis.site.name,
       .message = "a fixed joint has no axis: this one is ignored",
       .subject = context.subject(joint),
       .fix = should_move(joint, axis, context)
                  ? std::nullopt
                  : fix_of("remove it", Applicability::kUnsafe, removed(context, axis.site))});
}

Rule rule() {
  return {
      .name = "fixed-joint-with-axis",
      .severity = Severity::kInfo,
      .fix = FixGrade::kUnsafe,
      .summary = "a fixed joint has an axis",
      .why =
          "libsdformat and urdfdom ignore it. It is harmless, unless the joint was meant to move.",
      .what_to_do = "Take the axis out, or give the joint the type that was meant.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::fixed_joint_with_axis
