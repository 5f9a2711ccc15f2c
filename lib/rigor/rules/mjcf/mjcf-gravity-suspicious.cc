// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/read/mjcf/mjcf_settings.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_gravity_suspicious {

/// Models of insects are in centimeters, and of gears in millimeters.
bool is_of_earth_in_other_units(std::string_view text) {
  const auto g = read::mjcf_numbers(text);
  if (!g || g->size() != 3 || (*g)[0] != 0 || (*g)[1] != 0) return false;
  const auto is_near = [&](double gravity) { return std::abs(-(*g)[2] / gravity - 1) < 0.001; };
  return is_near(981) || is_near(980.665) || is_near(9810) || is_near(9806.65);
}

void check(const read::MjcfFact& fact, Context& context) {
  const bool units = is_of_earth_in_other_units(context.bytes(fact.where));
  context.report({.where = fact.where,
                  .message = "gravity " + fact.detail,
                  .subject = fact.subject,
                  .help = units ? "in centimeters or millimeters it is that of Earth" : "",
                  .severity = units ? std::optional(Severity::kInfo) : std::nullopt});
}

Rule rule() {
  return {
      .name = "mjcf-gravity-suspicious",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "gravity that no robot has",
      .why = "MuJoCo takes it: bodies fall up or sideways, or so fast that contacts are "
             "unstable. In MuJoCo the z axis points up.",
      .what_to_do = "Write gravity=\"0 0 -9.81\", or suppress the finding where it is meant.",
      .checks = {on_mjcf({read::MjcfFactKind::kGravity}, check)},
  };
}

}  // namespace rigor::rules::mjcf_gravity_suspicious
