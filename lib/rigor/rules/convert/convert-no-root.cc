// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_no_root {

void check(const convert::Note& note, Context& context) {
  context.report(refused(
      note, fmt::format("every link is a child of a joint ({}): there is no root", note.written)));
}

Rule rule() {
  return {
      .name = "convert-no-root",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "the joints form a circle without a beginning",
      .why =
          "Every link is the child of some joint, so none can be the root that a URDF begins with.",
      .what_to_do = "Take one joint out of the circle.",
      .checks = {on_conversion({convert::NoteKind::kNoRoot}, check)},
  };
}

}  // namespace rigor::rules::convert_no_root
