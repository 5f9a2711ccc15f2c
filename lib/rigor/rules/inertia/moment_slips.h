// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Slips of units in a link's mass and moments of inertia, and the edits that undo one.
//
//   for (const MomentSlip& slip : kMomentSlips) {
//     if (fits(mass * slip.mass, trace * slip.moments)) return undo(slip, inertial, context);
//   }

#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/context.h>
#include <rigor/write/numbers.h>

namespace rigor::rules {

/// What the mass or the moments have to be multiplied by.
struct MomentSlip {
  double mass = 1;
  double moments = 1;
  const char* help = "";
};

inline constexpr std::array<MomentSlip, 9> kMomentSlips{{
    {1, 1e-3, "the moments look as if they were in g·m²: divide them by 1e3"},
    {1, 1e-6, "the moments look as if they were in kg·mm²: divide them by 1e6"},
    {1, 1e-9, "the moments look as if they were in g·mm²: divide them by 1e9"},
    {1, 1e3, "the moments look as if they had been divided by 1e3 once too often"},
    {1, 1e6, "the moments look as if they had been divided by 1e6 once too often"},
    {1e-3, 1, "the mass looks as if it were in grams: divide it by 1e3"},
    {1e3, 1, "the mass looks as if it had been divided by 1e3 once too often"},
    {1e-2, 1, "the decimal point of the mass looks as if it had slipped: divide it by 100"},
    {1e2, 1, "the decimal point of the mass looks as if it had slipped: multiply it by 100"},
}};

/// The one slip that, undone, makes moments of a `share` of what the shapes have as solids fit them, and leaves
/// the shapes a `density` of some material, kg/m³; null without one.
inline const MomentSlip* slip_of_share(double share, double density) {
  constexpr double kNear = 2.5;       // hollow shapes have up to three times the moments
  constexpr double kLightest = 20;    // kg/m³, of foams
  constexpr double kHeaviest = 12e3;  // kg/m³, of lead
  const MomentSlip* found = nullptr;
  for (const MomentSlip& slip : kMomentSlips) {
    const double meant = share * slip.moments / slip.mass;
    const double would_be = density * slip.mass;
    if (meant > kNear || meant < 1 / kNear) continue;
    // A mass that is kept may be a token, but not one of what no body is made of.
    if (would_be > kHeaviest || (slip.mass != 1 && would_be < kLightest)) continue;
    if (found != nullptr) return nullptr;
    found = &slip;
  }
  return found;
}

/// `value` times a power of ten, with its digits kept.
inline std::string times_power_of_ten(double value, double power) {
  const double product = power < 1 ? value / std::round(1 / power) : value * power;
  return write::joined({write::settled(product, value, product)});
}

/// The edits that write what was meant.
inline Fix undo(const MomentSlip& slip, const model::Inertial& inertial) {
  if (slip.moments == 1) {
    const std::string mass = times_power_of_ten(inertial.mass.value, slip.mass);
    return {
        "write a mass of " + mass + " kg", Applicability::kUnsafe, {{inertial.mass.span, mass}}};
  }
  const auto power = static_cast<int>(std::lround(std::log10(slip.moments)));
  Fix fix{fmt::format("{} the moments of inertia by 1e{}", power < 0 ? "divide" : "multiply",
                      std::abs(power)),
          Applicability::kUnsafe,
          {}};
  for (const auto* entry :
       {&inertial.ixx, &inertial.ixy, &inertial.ixz, &inertial.iyy, &inertial.iyz, &inertial.izz}) {
    if (!entry->written || entry->value == 0) continue;
    fix.edits.push_back({entry->span, times_power_of_ten(entry->value, slip.moments)});
  }
  return fix;
}

}  // namespace rigor::rules
