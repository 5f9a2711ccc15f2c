// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::frame_reference_reserved {

void check(const model::FrameProblem& problem, Context& context) {
  context.report({.where = problem.where,
                  .message = "'" + problem.name +
                             "' is a name that only the parser uses: nothing can refer to it",
                  .subject = problem.subject});
}

Rule rule() {
  return {
      .name = "frame-reference-reserved",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "a reference to a frame that only the parser may name",
      .why = "Names with two underscores before and behind are kept for the parser; libsdformat "
             "refuses a reference to any but __model__.",
      .what_to_do = "Refer to __model__, to world (in the world), or to a frame of your own.",
      .checks = {on_frames({model::FrameProblemKind::kReservedReference}, check)},
  };
}

}  // namespace rigor::rules::frame_reference_reserved
