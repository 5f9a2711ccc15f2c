// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::canonical_link_missing {

void check(const model::FrameProblem& problem, Context& context) {
  context.report(unresolved(
      problem, "the canonical link '" + problem.name + "' is no link of this model", context));
}

Rule rule() {
  return {
      .name = "canonical-link-missing",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .fix = FixGrade::kUnsafe,
      .summary = "a model names a canonical link that does not exist",
      .why = "libsdformat refuses the model: its frame would be attached to nothing.",
      .what_to_do =
          "Name a link of the model, or leave the attribute out: the first link is taken then.",
      .checks = {on_frames({model::FrameProblemKind::kCanonicalLinkMissing}, check)},
  };
}

}  // namespace rigor::rules::canonical_link_missing
