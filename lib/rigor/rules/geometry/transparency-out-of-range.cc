// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::transparency_out_of_range {

/// Where a percentage was written: its share of one.
std::optional<Fix> as_share(const model::Field<double>& field) {
  if (!(field.value > 1) || field.value > 100) return std::nullopt;
  return Fix{"read it as per cent",
             Applicability::kUnsafe,
             {{field.span, fmt::format("{:.6g}", field.value / 100)}}};
}

void check(const model::Visual& visual, Context& context) {
  const auto& transparency = visual.transparency;
  if (transparency.value >= 0 && transparency.value <= 1) return;
  context.report(
      {.where = transparency.span,
       .message = fmt::format("the transparency is {}: it goes from 0, which is opaque, to 1, "
                              "which is invisible",
                              transparency.value),
       .subject = context.subject(visual),
       .fix = as_share(transparency)});
}

Rule rule() {
  return {
      .name = "transparency-out-of-range",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the transparency of a visual is below 0 or above 1",
      .why = "Above 1 nothing is left of the visual; below 0 the number means nothing. The opacity "
             "is 1 minus the transparency. Mostly it is in per cent, or the opacity was meant.",
      .what_to_do = "Write a number from 0 to 1; half transparent is 0.5.",
      .checks = {on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::transparency_out_of_range
