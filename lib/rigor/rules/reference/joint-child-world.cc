// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::joint_child_world {

void check(const model::FrameProblem& problem, Context& context) {
  context.report({.where = problem.where,
                  .message = "the world cannot be the child of a joint",
                  .subject = problem.subject});
}

Rule rule() {
  return {
      .name = "joint-child-world",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .summary = "a joint has the world as its child",
      .why = "libsdformat refuses the model: the child is what the joint moves, and the world does "
             "not move.",
      .what_to_do = "Swap the two: the world as parent, the link as child.",
      .checks = {on_frames({model::FrameProblemKind::kChildIsWorld}, check)},
  };
}

}  // namespace rigor::rules::joint_child_world
