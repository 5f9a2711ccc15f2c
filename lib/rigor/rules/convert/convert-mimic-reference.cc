// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_mimic_reference {

void check(const convert::Note& note, Context& context) {
  context.report(told(
      note, fmt::format("reference {} is folded into the offset: {}", note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-mimic-reference",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a mimic's reference was folded into its offset",
      .why =
          "SDF: follower = multiplier · (leader - reference) + offset. URDF has no reference: "
          "offset - multiplier · reference says the same.",
      .what_to_do = "Nothing: the joint is the same.",
      .checks = {on_conversion({convert::NoteKind::kMimicReference}, check)},
  };
}

}  // namespace rigor::rules::convert_mimic_reference
