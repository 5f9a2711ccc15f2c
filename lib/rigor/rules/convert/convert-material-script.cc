// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

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
      .checks = {on_conversion({convert::NoteKind::kMaterialScript}, check)},
  };
}

}  // namespace rigor::rules::convert_material_script
