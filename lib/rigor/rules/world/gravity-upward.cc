// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::gravity_upward {

/// Only the sign of z is another, and all digits stay.
std::optional<Fix> downward(const model::Field<model::Vector3>& gravity, const Context& context) {
  const std::string_view text = context.bytes(gravity.span);
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  const std::size_t z = text.find_last_of(" \t\r\n", last) + 1;
  if (text.empty() || last == text.npos || text[z] == '<') return std::nullopt;
  Span sign{gravity.span.source, gravity.span.begin + static_cast<std::uint32_t>(z), 0};
  sign.end = sign.begin + (text[z] == '+' ? 1 : 0);
  return Fix{"turn it round", Applicability::kUnsafe, {{sign, "-"}}};
}

void check(const model::World& world, Context& context) {
  const model::Vector3& gravity = world.gravity.value;
  if (!world.gravity.written || gravity.z <= 0) return;
  context.report({.where = world.gravity.span,
                  .message = fmt::format("gravity points up: z is {} m/s²", gravity.z),
                  .subject = context.subject(world),
                  .help = "the z axis of a world points up, so gravity is 0 0 -9.8",
                  .fix = downward(world.gravity, context)});
}

Rule rule() {
  return {
      .name = "gravity-upward",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the world's gravity points up",
      .why = "With the sign forgotten everything that is not static leaves the ground at the first "
             "step, in every simulator. The world's z axis points up, against gravity.",
      .what_to_do = "Write the vector with a minus sign: 0 0 -9.8.",
      .checks = {on<model::World>(check)},
  };
}

}  // namespace rigor::rules::gravity_upward
