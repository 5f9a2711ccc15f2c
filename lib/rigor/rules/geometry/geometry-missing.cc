// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/xacro.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::geometry_missing {

/// A child that is a misspelt <geometry> is told as an unknown element; a plugin may draw the visual.
bool has_another_reason(xml::Element part) {
  for (const xml::Element child : part.children()) {
    if (child.name() == "plugin" || !schema::near(child.name(), {"geometry"}).empty()) return true;
  }
  return false;
}

template <class Part>
void check(const Part& part, Context& context) {
  if (part.geometry.written) return;
  const xml::Element element = context.element(part.site);
  if (has_another_reason(element) || has_xacro_child(element)) return;
  context.report({.where = part.site.name,
                  .message = "<" + std::string(element.name()) + "> has no <geometry>",
                  .subject = context.subject(part)});
}

Rule rule() {
  return {
      .name = "geometry-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a collision or visual has no <geometry>",
      .why = "libsdformat takes it for a part without a shape: nothing is touched, or seen.",
      .what_to_do = "Add the <geometry> with its shape, or take the part out.",
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::geometry_missing
