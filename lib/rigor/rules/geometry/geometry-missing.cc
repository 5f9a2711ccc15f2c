// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>

namespace rigor::rules::geometry_missing {

template <class Part>
void check(const Part& part, Context& context) {
  if (part.geometry.written) return;
  // A misspelt <geometry> is reported as an unknown element; a plugin may draw the visual.
  if (has_near_child(part.site, "geometry", context) ||
      has_near_child(part.site, "plugin", context) || has_xacro_child(part.site, context)) {
    return;
  }
  context.report(
      {.where = part.site.name,
       .message = "<" + std::string(context.bytes(part.site.name)) + "> has no <geometry>",
       .subject = context.subject(part)});
}

Rule rule() {
  return {
      .name = "geometry-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a collision or visual has no <geometry>",
      .why = "libsdformat accepts it for a part without a shape: nothing is touched, or seen.",
      .what_to_do = "Add the <geometry> with its shape, or remove the visual or collision.",
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::geometry_missing
