// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string_view>
#include <utility>

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::relative_to_missing {

/// libsdformat looks for the frames of models, links, joints and frames while it loads, and for those of
/// all else when it is asked for them.
bool refused(const model::FrameProblem& problem, const Context& context) {
  const auto pose = context.document().element_at(problem.where.begin);
  const auto owner = pose ? pose->parent() : std::nullopt;
  if (!owner) return true;
  const std::string_view name = owner->name();
  return name != "visual" && name != "collision" && name != "sensor" && name != "light" &&
         name != "inertial" && name != "camera" && name != "particle_emitter";
}

void check(const model::FrameProblem& problem, Context& context) {
  Finding finding = unresolved(
      problem, "the pose is relative to '" + problem.name + "', which does not exist in this scope",
      context);
  finding.refused = refused(problem, context);
  finding.why = finding.refused
                    ? "libsdformat rejects the file: without the frame there is no pose."
                    : "Gazebo prints an error and takes the numbers relative to the element that "
                      "the pose is in, so the part is in another place than meant.";
  context.report(std::move(finding));
}

Rule rule() {
  return {
      .name = "relative-to-missing",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "a pose is relative to a frame that does not exist",
      .why = "Of a link, joint, frame or model libsdformat rejects the file: without the frame "
             "there is no pose. Of a visual, collision, sensor or light the simulator prints an "
             "error and takes the numbers as if no frame were named.",
      .what_to_do = "Name a link, joint, frame or model of the same scope. Only poses directly in "
                    "the world can refer to world.",
      .checks = {on_frames({model::FrameProblemKind::kRelativeToMissing}, check)},
  };
}

}  // namespace rigor::rules::relative_to_missing
