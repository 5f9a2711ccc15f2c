// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <limits>

#include <fmt/core.h>

#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::density_too_low {

// Foams and balloons aside, nothing is lighter: a carton has 50, a car 150.
constexpr double kLightest = 10;  // kg/m³

// Less is a token for a frame that had to have some mass.
constexpr double kMin = 1e-3;  // kg

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  const double mass = inertial.mass.value;
  if (!inertial.mass.written || !(mass > kMin) || mass::is_automatic(link)) return;
  if (!is_dynamic(link, context)) return;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double volume = kNone;  // m³
  for (const mass::From from : {mass::From::kCollisions, mass::From::kVisuals}) {
    if (const auto solid = solid_of_all(link, from, context))
      volume = std::min(volume, solid->mass);
    if (mass >= kLightest * volume) return;  // the visuals' meshes need not be opened
  }
  if (volume == kNone) return;
  context.report(
      {.where = inertial.mass.span,
       .message = fmt::format("{} kg in shapes of {:.3g} m³ are {:.3g} kg/m³: as light as "
                              "{}",
                              mass, volume, mass / volume,
                              mass < kAir * volume ? "air" : "a blown-up balloon"),
       .subject = context.subject(link)});
}

Rule rule() {
  return {
      .name = "density-too-low",
      .severity = Severity::kInfo,
      .summary = "a link weighs less than its shapes would have of any solid material",
      .why = "A body that is far too light is thrown about by whatever touches it, and rests badly "
             "beneath a heavy one. A mass of 1 kg is what templates hold.",
      .what_to_do = "Weigh the body, or let `rigor inertia MODEL --density KG_PER_M3` compute its "
                    "mass. What is hollow or blown up may be right as it is.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::density_too_low
