// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_massless {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("weighs nothing: {}", note.instead)));
}

Rule rule() {
  return {
      .name = "convert-massless",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kUrdf,
      .summary = "a link without mass",
      .why =
          "In URDF a link without an inertial weighs nothing and mostly serves as a frame; SDF "
          "would give it 1 kg, and the official converter drops it with all links below it.",
      .what_to_do = "Nothing, or write the inertial that the link really has.",
      .checks = {on_conversion({convert::NoteKind::kMassless}, check)},
  };
}

}  // namespace rigor::rules::convert_massless
