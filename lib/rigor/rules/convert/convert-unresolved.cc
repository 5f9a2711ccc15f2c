// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_unresolved {

void check(const convert::Note& note, Context& context) {
  context.report(
      refused(note, fmt::format("{} leads nowhere: the robot cannot be told", note.written)));
}

Rule rule() {
  return {
      .name = "convert-unresolved",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "a reference or an include leads nowhere",
      .why =
          "Where a part of the model cannot be found or placed, any robot that is written would be "
          "another one.",
      .what_to_do = "Put the reference right; `rigor validate` says what was tried.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <link name='tip'>
      <pose relative_to='«elbw»'>0 0 1 0 0 0</pose>
    </link>
    <joint name='elbow' type='fixed'>
      <parent>base</parent>
      <child>tip</child>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfArm}},
      .checks = {on_conversion({convert::NoteKind::kUnresolved}, check)},
  };
}

}  // namespace rigor::rules::convert_unresolved
