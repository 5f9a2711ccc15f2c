// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>

#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::color_invisible {

void check_material(const model::Site& site, Context& context) {
  const auto color = context.element(site).child("color");
  const auto rgba = color ? color->attribute("rgba") : std::nullopt;
  if (!rgba) return;
  const auto numbers = write::numbers_in(rgba->value());
  if (!numbers || numbers->size() != 4 || numbers->back() != 0) return;
  auto opaque = *numbers;
  opaque.back() = 1;
  context.report({.where = rgba->value_span(),
                  .message = "the color '" + std::string(rgba->value()) +
                             "' has an alpha of 0: what is painted with it is invisible",
                  .fix = Fix{"make it opaque",
                             Applicability::kUnsafe,
                             {{rgba->value_span(), write::joined(opaque)}}}});
}

void check(const model::Root& root, Context& context) {
  for (const model::RobotMaterial& material : root.materials) {
    if (root.own(material.site)) check_material(material.site, context);
  }
  for (const model::Visual& visual : root.visuals) {
    if (visual.material.written && root.own(visual.material.site)) {
      check_material(visual.material.site, context);
    }
  }
}

Rule rule() {
  return {
      .name = "color-invisible",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a material's color is transparent altogether",
      .why = "RViz and Gazebo draw nothing where the fourth number of rgba, the opacity, is 0: "
             "the link is there and is not seen. Who wants no visual writes none.",
      .what_to_do = "Write 1 for an opaque color, or take the visual out.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::color_invisible
