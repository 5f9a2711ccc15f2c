// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::light_shines_up {

using model::Vector3;

// Of the direction's length: a sun that sets shines along the ground.
constexpr double kUpward = 0.1;

void check(const model::Root& root, Context& context) {
  for (std::uint32_t i = 0; i < root.lights.size(); ++i) {
    const model::Light& light = root.lights[i];
    // A link may be anywhere, and turn; a spot light may shine at a ceiling.
    if (light.type.value != "directional" || light.link || !root.own(light.site)) continue;
    const Vector3& d = light.direction.value;
    const auto X_WL = context.frames().pose(model::Id<model::Light>{i});
    if (!light.direction.written || !X_WL || !(length(d) > 0)) continue;
    const Vector3 d_W = rotate(X_WL->rotation, d);
    if (d_W.z <= kUpward * length(d)) continue;
    const bool plain = rotate(X_WL->rotation, {0, 0, 1}).z > 0.999;
    std::optional<Fix> fix;
    if (plain) {
      fix = Fix{"let it shine down",
                Applicability::kUnsafe,
                {{light.direction.span, write::joined({d.x, d.y, -d.z})}}};
    }
    context.report({.where = light.direction.span,
                    .message = fmt::format(
                        "the directional light shines up: z of its direction is {:.3g}", d_W.z),
                    .subject = context.subject(light),
                    .fix = std::move(fix)});
  }
}

Rule rule() {
  return {
      .name = "light-shines-up",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a directional light shines up",
      .why = "The world is lit from below: what is seen from above is dark, and cameras see it "
             "so. The direction of a directional light, as of a sun, is where its light goes.",
      .what_to_do = "Negate z: -0.5 0.1 -0.9 is a sun in the sky.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::light_shines_up
