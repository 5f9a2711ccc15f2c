// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::placement_frame_missing {

void check(const model::FrameProblem& problem, Context& context) {
  context.report(unresolved(
      problem, "the placement frame '" + problem.name + "' is nothing in this model", context));
}

Rule rule() {
  return {
      .name = "placement-frame-missing",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .fix = FixGrade::kUnsafe,
      .summary = "a model is placed by a frame that does not exist",
      .why =
          "libsdformat refuses the model: its pose is that of the placement frame, which has none.",
      .what_to_do = "Name a frame, link or joint of the model.",
      .checks = {on_frames({model::FrameProblemKind::kPlacementFrameMissing}, check)},
  };
}

}  // namespace rigor::rules::placement_frame_missing
