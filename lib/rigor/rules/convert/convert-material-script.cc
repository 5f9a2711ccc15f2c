// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/sample.h>
#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_material_script {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("material script {} {}", note.written,
                             note.instead.empty() ? "is lost" : "becomes " + note.instead)));
}

Rule rule() {
  return {
      .name = "convert-material-script",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a material script becomes its colour",
      .why =
          "URDF has colours and textures. Gazebo's own scripts have known colours, which are "
          "written; of other scripts only the name can be carried.",
      .what_to_do = "Nothing, or write the colour into the visual.",
      .bad = {{.text = R"(<sdf version='1.9'>
  <model name='arm'>
    <link name='base'>
      <inertial>
        <mass>2</mass>
        <inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>
      </inertial>
      <visual name='v'>
        <geometry>
          <box>
            <size>1 1 1</size>
          </box>
        </geometry>
        <material>
          <«script»>
            <uri>file://media/materials/scripts/gazebo.material</uri>
            <name>Gazebo/Blue</name>
          </script>
        </material>
      </visual>
    </link>
  </model>
</sdf>
)"}},
      .good = {{.text = kSdfLink}},
      .checks = {on_conversion({convert::NoteKind::kMaterialScript}, check)},
  };
}

}  // namespace rigor::rules::convert_material_script
