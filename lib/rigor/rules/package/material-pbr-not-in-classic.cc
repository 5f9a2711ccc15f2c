// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string_view>

#include <rigor/rules/rule.h>

namespace rigor::rules::material_pbr_not_in_classic {

void check(const model::Visual& visual, Context& context) {
  const model::Material& material = visual.material;
  const bool scripted = !material.script.span.nowhere();
  if (material.pbr.span.nowhere() || scripted || material.has_color) return;
  context.report(
      {.where = material.pbr.name,
       .message = "Gazebo classic passes over <pbr>, and nothing else says how this looks",
       .subject = context.subject(visual)});
}

Rule rule() {
  return {
      .name = "material-pbr-not-in-classic",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .targets = {Target::kGazeboClassic},
      .summary = "a visual gets its look from <pbr> alone",
      .why =
          "Gazebo classic has no physically based rendering. It draws the part without a texture.",
      .what_to_do = "Add <ambient> and <diffuse>, or a material <script>: gz-sim goes on using the "
                    "<pbr> beside them.",
      .checks = {on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::material_pbr_not_in_classic
