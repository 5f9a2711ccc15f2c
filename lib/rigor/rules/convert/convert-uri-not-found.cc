// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_uri_not_found {

void check(const convert::Note& note, Context& context) {
  context.report(told(
      note, fmt::format("{} is found nowhere; it is written as {}", note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-uri-not-found",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "a mesh that cannot be found",
      .why =
          "The file is nowhere where rigor looked, so the result names it as the source does, and "
          "nobody has seen it.",
      .what_to_do = "Say where to search: `--model-path DIR` or `--package NAME=DIR`.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
      <visual name='v'>
        <geometry>
          <mesh>
            <uri>«model://nowhere/meshes/hull.obj»</uri>
          </mesh>
        </geometry>
      </visual>
    </link>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfLink}},
      .checks = {on_conversion({convert::NoteKind::kUriNotFound}, check)},
  };
}

}  // namespace rigor::rules::convert_uri_not_found
