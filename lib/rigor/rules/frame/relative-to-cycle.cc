// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/frame/chain.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::relative_to_cycle {

void check(const model::FrameProblem& problem, Context& context) {
  report_cycle(problem, "poses are relative to each other", context);
}

Rule rule() {
  return {
      .name = "relative-to-cycle",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .summary = "poses are relative to each other in a circle",
      .why = "libsdformat refuses the file: nothing in the circle has a place.",
      .what_to_do = "Give one of the frames a pose relative to something outside the circle, such "
                    "as __model__.",
      .checks = {on_frames({model::FrameProblemKind::kRelativeToCycle}, check)},
  };
}

}  // namespace rigor::rules::relative_to_cycle
