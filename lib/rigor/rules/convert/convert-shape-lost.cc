// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_shape_lost {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("there is no {} in the target: the shape is left out", note.written)));
}

Rule rule() {
  return {
      .name = "convert-shape-lost",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "a shape that the target lacks is left out",
      .why =
          "The link loses what it collides or is seen with. A robot that lost a collision falls "
          "through things.",
      .what_to_do =
          "Convert with `--shapes mesh`, which writes mesh files, or choose a shape that both "
          "formats have.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
      <collision name='v'>
        <geometry>
          <«plane»>
            <normal>0 0 1</normal>
            <size>1 1</size>
          </plane>
        </geometry>
      </collision>
    </link>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfLink}},
      .checks = {on_conversion({convert::NoteKind::kShapeLost}, check)},
  };
}

}  // namespace rigor::rules::convert_shape_lost
