// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::expressed_in_missing {

void check(const model::FrameProblem& problem, Context& context) {
  context.report(unresolved(
      problem, "the axis is expressed in '" + problem.name + "', which is nothing in this scope",
      context));
}

Rule rule() {
  return {
      .name = "expressed-in-missing",
      .severity = Severity::kError,
      .fix = FixGrade::kUnsafe,
      .summary = "a joint axis is expressed in a frame that does not exist",
      .why = "ign sdf -k calls the file valid, but whoever asks for the axis, the simulator among "
             "them, gets an error instead.",
      .what_to_do =
          "Name a link, joint, frame or model of the same scope; __model__ is the model itself.",
      .checks = {on_frames({model::FrameProblemKind::kExpressedInMissing}, check)},
  };
}

}  // namespace rigor::rules::expressed_in_missing
