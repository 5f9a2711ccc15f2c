// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/fact.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::old_root {

void check(const read::Fact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = "the root element is <gazebo>: since SDF 1.3 it is <sdf>",
       .fix = fix_of("write <sdf>", Applicability::kUnsafe,
                     xml::rename_element(context.document(), *context.document().root(), "sdf"))});
}

Rule rule() {
  return {
      .name = "old-root",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the root element is <gazebo>, as before SDF 1.3",
      .why = "libsdformat refuses the file today: it looks for <sdf>.",
      .what_to_do = "Upgrade the file to a current version.",
      .checks = {on_read({read::FactKind::kOldRoot}, check)},
  };
}

}  // namespace rigor::rules::old_root
