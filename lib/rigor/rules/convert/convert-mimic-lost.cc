// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_mimic_lost {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("the joint no longer follows {}: {}", note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-mimic-lost",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "a joint that followed another moves on its own",
      .why =
          "The leader is missing, has two axes, or the target's version has no mimic joints. A "
          "finger that followed its neighbour now hangs loose.",
      .what_to_do =
          "Follow in the controller, or choose a version that has mimic joints: SDF 1.11.",
      .checks = {on_conversion({convert::NoteKind::kMimicLost}, check)},
  };
}

}  // namespace rigor::rules::convert_mimic_lost
