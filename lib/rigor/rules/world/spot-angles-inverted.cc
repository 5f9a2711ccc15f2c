// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::spot_angles_inverted {

void check(const model::Light& light, Context& context) {
  if (light.type.value != "spot") return;
  const auto& inner = light.spot_inner_angle;
  const auto& outer = light.spot_outer_angle;
  if (!inner.written || !outer.written || inner.value <= outer.value) return;
  context.report(
      {.where = inner.span,
       .message = fmt::format("the inner angle of the spot light, {:.4g} rad, is larger than the "
                              "outer one, {:.4g} rad",
                              inner.value, outer.value),
       .subject = context.subject(light),
       .related = {{outer.span, "the outer angle"}},
       .fix = swap("swap them", inner.span, outer.span, context)});
}

Rule rule() {
  return {
      .name = "spot-angles-inverted",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the inner angle of a spot light is larger than the outer one",
      .why = "A spot light is full within the inner cone and fades towards the outer one. With the "
             "inner one outside, the fading runs the wrong way: the light has a hard edge, or a "
             "dark middle.",
      .what_to_do = "Swap the two; both are in radians.",
      .checks = {on<model::Light>(check)},
  };
}

}  // namespace rigor::rules::spot_angles_inverted
