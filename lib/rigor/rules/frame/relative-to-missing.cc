// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::relative_to_missing {
namespace {

void check(const model::FrameProblem& problem, Context& context) {
  context.report(
      {.where = problem.where,
       .message = "the pose is relative to '" + problem.name + "', which is nothing in this scope",
       .subject = problem.subject,
       .help = did_you_mean(problem.name, problem.candidates)});
}

}  // namespace

Rule rule() {
  return {
      .name = "relative-to-missing",
      .category = Category::kFrame,
      .severity = Severity::kError,
      .summary = "a pose is relative to a frame that does not exist",
      .why = "libsdformat refuses the file: without the frame there is no pose.",
      .what_to_do =
          "Name a link, joint, frame or model of the same scope. The world can be named "
          "only from a pose that stands in the world itself.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="tip">
      <pose relative_to="«bse»">1 0 0 0 0 0</pose>
    </link>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="tip">
      <pose relative_to="base">1 0 0 0 0 0</pose>
    </link>
  </model>
</sdf>
)"}},
      .checks = {on_frames({model::FrameProblemKind::kRelativeToMissing}, check)},
  };
}

}  // namespace rigor::rules::relative_to_missing
