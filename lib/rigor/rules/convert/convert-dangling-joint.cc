// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_dangling_joint {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("connects nothing: {}", note.written)));
}

Rule rule() {
  return {
      .name = "convert-dangling-joint",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "a joint has no link at one end",
      .why =
          "Its parent or child names nothing, or the child is the world. No consumer can build the "
          "joint.",
      .what_to_do = "Name two links of the model; the parent may be `world`.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <link name='tip'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <joint name='elbow' type='fixed'>
      <parent>base</parent>
      <child>tip</child>
    </joint>
    <«joint» name='ghost' type='fixed'>
      <parent>base</parent>
      <child>nobody</child>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfArm}},
      .checks = {on_conversion({convert::NoteKind::kDanglingJoint}, check)},
  };
}

}  // namespace rigor::rules::convert_dangling_joint
