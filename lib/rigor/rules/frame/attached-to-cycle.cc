// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/frame/chain.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::attached_to_cycle {

void check(const model::FrameProblem& problem, Context& context) {
  report_cycle(problem, "frames are attached to each other", context);
}

Rule rule() {
  return {
      .name = "attached-to-cycle",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .summary = "frames are attached to each other in a circle",
      .why = "libsdformat refuses the file: no frame of the circle reaches a link.",
      .what_to_do = "Attach one of the frames to a link.",
      .checks = {on_frames({model::FrameProblemKind::kAttachedToCycle}, check)},
  };
}

}  // namespace rigor::rules::attached_to_cycle
