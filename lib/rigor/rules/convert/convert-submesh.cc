// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_submesh {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("submesh {} {}", note.written,
                             note.instead.empty() ? "is left out: URDF takes meshes whole"
                                                  : "becomes " + note.instead)));
}

Rule rule() {
  return {
      .name = "convert-submesh",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a part of a mesh file",
      .why = "URDF takes mesh files whole. A submesh by name cannot be told.",
      .what_to_do =
          "Write the part to a file of its own: `rigor mesh-check FILE --split material -o PART`.",
      .checks = {on_conversion({convert::NoteKind::kSubmesh}, check)},
  };
}

}  // namespace rigor::rules::convert_submesh
