// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <unordered_set>

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::material_undefined {

/// Whether the color is there under another name, as rgb: unknown-attribute says so.
bool has_misspelt_color(const model::Site& site, const Context& context) {
  const auto color = context.element(site).child("color");
  if (!color || color->attribute("rgba")) return false;
  for (const xml::Attribute attribute : color->attributes()) {
    if (!schema::near(attribute.name(), {"rgba"}).empty()) return true;
  }
  return false;
}

void check(const model::Root& root, Context& context) {
  std::unordered_set<std::string_view> defined;
  for (const model::RobotMaterial& material : root.materials) {
    if (material.defines_color || has_misspelt_color(material.site, context))
      defined.insert(material.name.value);
  }
  for (const model::Visual& visual : root.visuals) {
    const model::Material& material = visual.material;
    if (material.defines_color || (material.written && has_misspelt_color(material.site, context)))
      defined.insert(material.name.value);
  }
  for (const model::Visual& visual : root.visuals) {
    const model::Material& material = visual.material;
    const std::string& name = material.name.value;
    if (!material.written || name.empty() || defined.count(name) != 0) continue;
    const bool colorless = name_set(root.materials).count(name) != 0;
    context.report(with_nearest(
        {.where = material.name.span,
         .message = "the material '" + name + "' is defined " +
                    (colorless ? "without a color" : "nowhere in this robot"),
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
          "urdfdom warns and gives the visual no material; it is then drawn in whatever color the "
          "viewer likes. Gazebo's own material names (Gazebo/Orange) belong into a <gazebo> block.",
      .what_to_do = "Define the material with a color, in the visual or once under <robot>.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::material_undefined
