// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_link_frame {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("the link's frame moves to its joint, by {}", note.written)));
}

Rule rule() {
  return {
      .name = "convert-link-frame",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a link's frame moves to its joint",
      .why =
          "In URDF a link's frame is that of its joint. What the link holds is moved the other "
          "way, so that nothing moves; only the frame by the link's name is elsewhere.",
      .what_to_do =
          "Where code asks for the old frame, convert with `--keep-link-frames`: it stays as a "
          "link of its own.",
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
    <joint name='elbow' type='revolute'>
      <parent>base</parent>
      <child>tip</child>
      <pose>«0 0 0.1 0 0 0»</pose>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <lower>-1</lower>
          <upper>1</upper>
          <effort>5</effort>
          <velocity>2</velocity>
        </limit>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfArm}},
      .checks = {on_conversion({convert::NoteKind::kLinkFrame}, check)},
  };
}

}  // namespace rigor::rules::convert_link_frame
