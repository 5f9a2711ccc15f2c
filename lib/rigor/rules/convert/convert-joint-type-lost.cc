// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_joint_type_lost {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("there is no {} joint in the target, and nothing can stand for it{}{}",
                             note.written, note.instead.empty() ? "" : ": ", note.instead)));
}

Rule rule() {
  return {
      .name = "convert-joint-type-lost",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "the target has no such joint, and nothing stands for it",
      .why = "A joint that cannot be told is left out or welded: the mechanism moves otherwise.",
      .what_to_do = "Rebuild it from joints that both formats have.",
      .checks = {on_conversion({convert::NoteKind::kJointTypeLost}, check)},
  };
}

}  // namespace rigor::rules::convert_joint_type_lost
