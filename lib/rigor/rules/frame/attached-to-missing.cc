// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::attached_to_missing {

void check(const model::FrameProblem& problem, Context& context) {
  context.report(unresolved(
      problem, "the frame is attached to '" + problem.name + "', which is nothing in this scope",
      context));
}

Rule rule() {
  return {
      .name = "attached-to-missing",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .fix = FixGrade::kUnsafe,
      .summary = "a frame is attached to something that does not exist",
      .why = "libsdformat refuses the file: a frame moves with what it is attached to.",
      .what_to_do = "Name a link, joint, frame or model of the same scope.",
      .checks = {on_frames({model::FrameProblemKind::kAttachedToMissing}, check)},
  };
}

}  // namespace rigor::rules::attached_to_missing
