// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::joint_child_missing {

void check(const model::FrameProblem& problem, Context& context) {
  const Suggestion near = suggest(problem.name, problem.candidates, problem.where, context);
  context.report({.where = problem.where,
                  .message = "the child '" + problem.name + "' is nothing in this model",
                  .subject = problem.subject,
                  .help = near.help,
                  .fix = near.fix,
                  // Joints of a world came with SDF 1.10; libsdformat 12 reads none.
                  .refused = static_cast<bool>(problem.model)});
}

Rule rule() {
  return {
      .name = "joint-child-missing",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kAlways},
      .fix = FixGrade::kUnsafe,
      .summary = "a joint names a child that does not exist",
      .why =
          "libsdformat and urdfdom refuse the whole model: a joint without a child moves nothing.",
      .what_to_do = "Name a link, joint, frame or nested model of the same model.",
      .checks = {on_frames({model::FrameProblemKind::kChildMissing}, check)},
  };
}

}  // namespace rigor::rules::joint_child_missing
