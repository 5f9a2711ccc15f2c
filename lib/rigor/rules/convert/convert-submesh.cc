// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_submesh {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("submesh {} {}", note.written,
                             note.instead.empty() ? "is left out: URDF takes meshes whole"
                                                  : "becomes " + note.instead)));
}

Rule rule() {
  return {
      .name = "convert-submesh",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a part of a mesh file",
      .why = "URDF takes mesh files whole. A submesh by name cannot be told.",
      .what_to_do =
          "Write the part to a file of its own: `rigor mesh-check FILE --split material -o PART`.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
      <visual name='v'>
        <geometry>
          <«mesh»>
            <uri>meshes/hull.obj</uri>
            <submesh>
              <name>lid</name>
            </submesh>
          </mesh>
        </geometry>
      </visual>
    </link>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfLink}},
      .checks = {on_conversion({convert::NoteKind::kSubmesh}, check)},
  };
}

}  // namespace rigor::rules::convert_submesh
