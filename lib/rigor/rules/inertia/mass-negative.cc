// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/refused_inertia.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mass_negative {

/// Only the sign goes where that gives the shapes a density that bodies have.
std::optional<Fix> fix_of_sign(const model::Link& link, Context& context) {
  const auto& mass = link.inertial.mass;
  const std::string_view bytes = context.bytes(mass.span);
  const std::size_t minus = bytes.find_first_not_of(" \t\r\n");
  if (minus == std::string_view::npos || bytes[minus] != '-') return std::nullopt;
  for (const mass::From from : {mass::From::kCollisions, mass::From::kVisuals}) {
    const auto solid = solid_of_all(link, from, context);
    if (!solid || -mass.value > kDensestOfParts * solid->mass) continue;
    if (-mass.value < kAir * solid->mass) continue;
    Span sign = mass.span;
    sign.begin += static_cast<std::uint32_t>(minus);
    sign.end = sign.begin + 1;
    return Fix{"take the minus away", Applicability::kUnsafe, {{sign, ""}}};
  }
  return std::nullopt;
}

void check(const model::Link& link, Context& context) {
  const auto& mass = link.inertial.mass;
  if (!mass.written || !(mass.value < 0) || !std::isfinite(mass.value)) return;
  std::optional<Fix> fix = fix_of_sign(link, context);
  if (!fix) fix = fix_from_shapes(link, context);
  context.report({.where = mass.span,
                  .message = fmt::format("the mass is {} kg: it must be above zero", mass.value),
                  .subject = context.subject(link),
                  .fix = std::move(fix),
                  .refused = refuses_inertia(link, context)});
}

Rule rule() {
  return {
      .name = "mass-negative",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "a mass is negative",
      .why = "libsdformat refuses the model. urdfdom takes it, and the simulation then explodes: "
             "what is pushed comes nearer.",
      .what_to_do = "Write a mass above zero.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::mass_negative
