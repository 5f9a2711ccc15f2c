// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/values.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>

namespace rigor::rules::axis_missing {

void check(const model::Joint& joint, Context& context) {
  const xml::Element element = context.element(joint.site);
  if (!has_axis(joint.type) || has_xacro_child(element)) return;
  if (!element.child("axis")) {
    context.report({.where = joint.site.name,
                    .message = "the " + std::string(to_string(joint.type)) +
                               " joint has no <axis>: it is taken to move along " +
                               (context.is_urdf() ? "x (1 0 0)" : "z (0 0 1)"),
                    .subject = context.subject(joint)});
    return;
  }
  if (context.is_urdf()) return;  // missing-attribute
  for (const model::Axis& axis : joint.axes) {
    const xml::Element written = context.element(axis.site);
    if (!read::trimmed(written.text()).empty()) continue;  // text-between-elements
    if (written.child("xyz") || written.attribute("xyz") || has_xacro_child(written)) continue;
    context.report({.where = axis.site.name,
                    .message = "the <" + std::string(written.name()) +
                               "> has no <xyz>: the joint is taken to move along z (0 0 1)",
                    .subject = context.subject(joint)});
  }
}

Rule rule() {
  return {
      .name = "axis-missing",
      .severity = Severity::kInfo,
      .summary = "a joint that moves along an axis has none",
      .why = "SDF then takes the z axis of the joint's frame, and URDF x, so the robot changes "
             "when it is converted by hand.",
      .what_to_do = "Write the axis: <axis><xyz>0 0 1</xyz></axis>, in URDF <axis xyz=\"1 0 0\"/>.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::axis_missing
