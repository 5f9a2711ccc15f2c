// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_mimic_chain {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("{} is no leader but follows, too: the joint follows {} now",
                             note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-mimic-chain",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a joint that followed a follower follows the leader of both",
      .why =
          "Most consumers of URDF look at one leader and take where it is told to be: who follows "
          "a "
          "follower stands still. Multipliers and offsets put together say the same motion.",
      .what_to_do = "Nothing: the joint moves the same.",
      .bad = {{.text = R"(<sdf version='1.11'>
  <model name='hand'>
    <link name='palm'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <link name='first'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <link name='second'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <link name='third'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
    </link>
    <joint name='a' type='continuous'>
      <parent>palm</parent>
      <child>first</child>
      <axis>
        <xyz>0 0 1</xyz>
      </axis>
    </joint>
    <joint name='b' type='continuous'>
      <parent>first</parent>
      <child>second</child>
      <axis>
        <xyz>0 0 1</xyz>
        <mimic joint='a'>
          <multiplier>2</multiplier>
          <offset>0.5</offset>
          <reference>0</reference>
        </mimic>
      </axis>
    </joint>
    <joint name='c' type='continuous'>
      <parent>second</parent>
      <child>third</child>
      <axis>
        <xyz>0 0 1</xyz>
        <mimic joint='«b»'>
          <multiplier>3</multiplier>
          <offset>0</offset>
          <reference>0</reference>
        </mimic>
      </axis>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfArm}},
      .checks = {on_conversion({convert::NoteKind::kMimicChain}, check)},
  };
}

}  // namespace rigor::rules::convert_mimic_chain
