// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::top_level_pose_relative_to {

constexpr int kSince = 7;

void check(const model::Model& model, Context& context) {
  if (model.parent || model.world || context.root().version < kSince) return;
  const model::Field<std::string>& frame = model.pose.relative_to;
  // Other names are reported as the nothing, or the circle, that they are.
  if (!frame.written || frame.value != "world") return;
  context.report(
      {.where = frame.span,
       .message = "no frame is around a model at the top of a file: relative_to has to be left out",
       .subject = context.subject(model),
       .fix = fix_of("take it out", Applicability::kSafe,
                     attribute_removed(context, model.pose.site, "relative_to"))});
}

Rule rule() {
  return {
      .name = "top-level-pose-relative-to",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .fix = FixGrade::kSafe,
      .summary = "the pose of a model at the top of a file is relative to a frame",
      .why = "Such a model has no surrounding frame: the including file places it. libsdformat "
             "rejects the file: relative_to must be left empty there, even for \"world\".",
      .what_to_do = "Take relative_to out.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::top_level_pose_relative_to
