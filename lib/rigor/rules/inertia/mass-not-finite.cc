// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/core.h>

#include <rigor/rules/inertia/refused_inertia.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mass_not_finite {

void check(const model::Link& link, Context& context) {
  const auto& mass = link.inertial.mass;
  if (!mass.written || std::isfinite(mass.value)) return;
  context.report(
      {.where = mass.span,
       .message = fmt::format("the mass is {}: it must be a finite number of kg", mass.value),
       .subject = context.subject(link),
       .refused = refuses_inertia(link, context)});
}

Rule rule() {
  return {
      .name = "mass-not-finite",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .summary = "a mass is infinite or not a number",
      .why = "libsdformat takes inf and nan: the simulation has no numbers after its first step. "
             "urdfdom drops the inertial with an error.",
      .what_to_do =
          "Write the mass in kg. What must not move is made static, or fixed to the world.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::mass_not_finite
