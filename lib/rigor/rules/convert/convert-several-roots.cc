// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_several_roots {

void check(const convert::Note& note, Context& context) {
  context.report(refused(note, fmt::format("{} links hang on no joint: {}; a URDF has one root",
                                           note.count, note.written)));
}

Rule rule() {
  return {
      .name = "convert-several-roots",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "the links form several trees",
      .why =
          "A URDF robot is one tree: urdfdom refuses a file with two roots. Joining them would "
          "invent a joint that the model does not have.",
      .what_to_do =
          "Add the joint that is missing, or convert with `--roots add`, which fixes all of them "
          "to one new root.",
      .checks = {on_conversion({convert::NoteKind::kSeveralRoots}, check)},
  };
}

}  // namespace rigor::rules::convert_several_roots
