// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_shape {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("there is no {} in the target: {}", note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-shape",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "another shape stands for one that the target lacks",
      .why =
          "URDF 1.0 has boxes, cylinders, spheres and meshes. A capsule is exactly a cylinder and "
          "two spheres; other shapes become mesh files.",
      .what_to_do = "Nothing where the substitute is exact; else choose a shape that both have.",
      .checks = {on_conversion({convert::NoteKind::kShape}, check)},
  };
}

}  // namespace rigor::rules::convert_shape
