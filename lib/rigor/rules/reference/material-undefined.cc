// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::material_undefined {

void check(const model::Root& root, Context& context) {
  std::unordered_set<std::string_view> defined;
  for (const model::RobotMaterial& material : root.materials) {
    if (material.defines_color) defined.insert(material.name.value);
  }
  for (const model::Visual& visual : root.visuals) {
    if (visual.material.defines_color) defined.insert(visual.material.name.value);
  }
  for (const model::Visual& visual : root.visuals) {
    const model::Material& material = visual.material;
    const std::string& name = material.name.value;
    if (!material.written || name.empty() || defined.count(name) != 0) continue;
    const bool colorless = name_set(root.materials).count(name) != 0;
    context.report(with_nearest(
        {.where = material.name.span,
         .message = "the material '" + name + "' is defined " +
                    (colorless ? "without a colour" : "nowhere in this robot"),
         .subject = context.subject(visual)},
        name, [&] { return names_of(root.materials); }, context));
  }
}

Rule rule() {
  return {
      .name = "material-undefined",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a visual names a material that is defined nowhere",
      .why =
          "urdfdom warns and gives the visual no material; it is then drawn in whatever colour the "
          "viewer likes. Gazebo's own material names (Gazebo/Orange) belong into a <gazebo> block.",
      .what_to_do = "Define the material with a colour, in the visual or once under <robot>.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::material_undefined
