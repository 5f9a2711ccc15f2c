// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_mimic_reference {

void check(const convert::Note& note, Context& context) {
  context.report(told(
      note, fmt::format("reference {} is folded into the offset: {}", note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-mimic-reference",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a mimic's reference was folded into its offset",
      .why =
          "SDF: follower = multiplier · (leader - reference) + offset. URDF has no reference: "
          "offset - multiplier · reference says the same.",
      .what_to_do = "Nothing: the joint is the same.",
      .bad = {{.text = R"(<sdf version='1.11'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <link name='left'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <link name='right'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <joint name='lead' type='revolute'>
      <parent>base</parent>
      <child>left</child>
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
    <joint name='follow' type='revolute'>
      <parent>base</parent>
      <child>right</child>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <lower>-1</lower>
          <upper>1</upper>
          <effort>5</effort>
          <velocity>2</velocity>
        </limit>
        <mimic joint='lead'>
          <multiplier>2</multiplier>
          <offset>0.5</offset>
          <reference>«0.1»</reference>
        </mimic>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfArm}},
      .checks = {on_conversion({convert::NoteKind::kMimicReference}, check)},
  };
}

}  // namespace rigor::rules::convert_mimic_reference
