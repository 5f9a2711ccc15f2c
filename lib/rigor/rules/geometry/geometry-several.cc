// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>

namespace rigor::rules::geometry_several {

template <class Part>
void check(const Part& part, Context& context) {
  const model::Geometry& geometry = part.geometry;
  if (geometry.more.empty()) return;
  context.report({.where = geometry.more.front().name,
                  .message = "a geometry has one shape: beside the " +
                             std::string(model::shape_name(geometry.shape)) +
                             " this is a second one, and only one of them is taken",
                  .subject = context.subject(part),
                  .related = {{geometry.site.name, "the first shape"}}});
}

Rule rule() {
  return {
      .name = "geometry-several",
      .severity = Severity::kError,
      .summary = "a <geometry> holds more than one shape",
      .why = "libsdformat takes the first of its own order (box, capsule, cylinder, …), not the "
             "first in the file; urdfdom takes the first. The other is dropped without a word.",
      .what_to_do = "Give each shape a visual or collision of its own.",
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::geometry_several
