// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::light_direction_zero {

void check(const model::Light& light, Context& context) {
  if (light.type.value != "directional" && light.type.value != "spot") return;
  const auto& direction = light.direction;
  if (!direction.written || length(direction.value) > 0) return;
  context.report(
      {.where = direction.span,
       .message = "the direction of the " + light.type.value + " light is 0 0 0: it shines nowhere",
       .subject = context.subject(light),
       .fix = Fix{"let it shine down", Applicability::kUnsafe, {{direction.span, "0 0 -1"}}}});
}

Rule rule() {
  return {
      .name = "light-direction-zero",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a light shines in no direction",
      .why = "Normalized, zero stays zero or becomes nan: the scene is dark, or lit from anywhere. "
             "A directional or spot light shines along its direction.",
      .what_to_do = "Write the direction in the light's own frame; 0 0 -1 is down.",
      .checks = {on<model::Light>(check)},
  };
}

}  // namespace rigor::rules::light_direction_zero
