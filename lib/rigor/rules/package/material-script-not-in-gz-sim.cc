// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <string_view>

#include <rigor/rules/rule.h>

namespace rigor::rules::material_script_not_in_gz_sim {

void check(const model::Visual& visual, Context& context) {
  const model::Material& material = visual.material;
  if (!material.pbr.span.nowhere() || material.has_color) return;
  const std::string_view text = material.name.value;
  // The colors of Gazebo's own materials gz-sim knows by heart, from version 8.
  if (text.empty() || text.starts_with("Gazebo/") || text == "__default__") return;
  context.report({.where = material.name.span,
                  .message = "gz-sim reads no material scripts: nothing is seen of '" +
                             std::string(text) + "'",
                  .subject = context.subject(visual)});
}

Rule rule() {
  return {
      .name = "material-script-not-in-gz-sim",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .targets = {Target::kGzSim},
      .summary = "a visual gets its look from a material script alone",
      .why = "Material scripts are Ogre 1's. gz-sim warns that it does not support them, and draws "
             "the part plain. Only of the names Gazebo/… it knows the colors, from version 8 "
             "(Harmonic).",
      .what_to_do = "Add <ambient> and <diffuse> for a color, or <pbr><metal><albedo_map> for a "
                    "texture. Gazebo classic goes on reading the <script> beside them.",
      .checks = {on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::material_script_not_in_gz_sim
