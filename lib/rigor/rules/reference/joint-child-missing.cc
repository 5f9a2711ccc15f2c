// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <utility>

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::joint_child_missing {

void check(const model::FrameProblem& problem, Context& context) {
  Finding finding =
      unresolved(problem, "the child '" + problem.name + "' does not exist in this model", context);
  // Joints of a world came with SDF 1.10; libsdformat 12 reads none.
  finding.refused = static_cast<bool>(problem.model);
  if (finding.help.empty() && context.is_urdf()) finding.help = "name a link of the robot";
  context.report(std::move(finding));
}

Rule rule() {
  return {
      .name = "joint-child-missing",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kAlways},
      .fix = FixGrade::kUnsafe,
      .summary = "a joint names a child that does not exist",
      .why = "libsdformat rejects the whole file: a joint without a child moves nothing. urdfdom "
             "rejects "
             "the whole robot.",
      .what_to_do = "Name a link, joint, frame or nested model of the same model.",
      .checks = {on_frames({model::FrameProblemKind::kChildMissing}, check)},
  };
}

}  // namespace rigor::rules::joint_child_missing
