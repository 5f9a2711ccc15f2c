// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::axis_not_unit {
namespace {

// Four digits of 0.7071 are off by this much at most.
constexpr double kRounding = 1e-3;

void check(const model::Joint& joint, Context& context) {
  if (!has_axis(joint.type)) return;
  for (const model::Axis& axis : joint.axes) {
    const double length = model::length(axis.xyz.value);
    if (!axis.xyz.written || length == 0 || std::abs(length - 1) < kRounding) continue;
    context.report({.where = axis.xyz.span,
                    .message = fmt::format("the axis has length {:.4g}, not 1", length),
                    .subject = context.subject(joint)});
  }
}

}  // namespace

Rule rule() {
  return {
      .name = "axis-not-unit",
      .category = Category::kKinematics,
      .severity = Severity::kInfo,
      .summary = "a joint axis is not a unit vector",
      .why =
          "libsdformat makes its length one. Readers of URDF differ: some scale the joint's "
          "speed by the length.",
      .what_to_do = "Divide the axis by its length.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="tip"/>
    <joint name="elbow" type="revolute">
      <parent>base</parent>
      <child>tip</child>
      <axis>
        <xyz>«0 1 1»</xyz>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="tip"/>
    <joint name="elbow" type="revolute">
      <parent>base</parent>
      <child>tip</child>
      <axis>
        <xyz>0 0.7071 0.7071</xyz>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::axis_not_unit
