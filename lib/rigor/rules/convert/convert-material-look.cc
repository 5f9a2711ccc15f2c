// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_material_look {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("{} of the material {}", note.written,
                             note.instead.empty() ? "is lost" : "becomes " + note.instead)));
}

Rule rule() {
  return {
      .name = "convert-material-look",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "some of how a visual looks is lost",
      .why =
          "The target has one colour or texture a visual: textures of a pbr material, emission, "
          "highlights and shaders have no place.",
      .what_to_do = "Put the look into the mesh file, which both formats take.",
      .checks = {on_conversion({convert::NoteKind::kMaterialLook}, check)},
  };
}

}  // namespace rigor::rules::convert_material_look
