// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A fact of a simulation as a finding.

#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/simulate/rows.h>

namespace rigor::rules {
namespace simulation {

constexpr std::span<const Row> (*kTables[])() = {refused_rows, as_read_rows, run_rows,  stand_rows,
                                                 drive_rows,   joint_rows,   cause_rows};

/// Degrees in a radian: messages have angles in degrees.
constexpr double kDegrees = 57.29577951308232;

std::string length_text(double meters) {
  return meters < 1 ? fmt::format("{:.3g} mm", 1e3 * meters) : fmt::format("{:.3g} m", meters);
}

std::string message_of(const simulate::Fact& fact, const Row& row) {
  return fmt::format(
      fmt::runtime(row.message.text(fact)), fmt::arg("name", fact.name),
      fmt::arg("value", fact.value), fmt::arg("limit", fact.limit),
      fmt::arg("value_mm", 1e3 * fact.value), fmt::arg("limit_mm", 1e3 * fact.limit),
      fmt::arg("value_deg", fact.value * kDegrees), fmt::arg("limit_deg", fact.limit * kDegrees),
      fmt::arg("value_percent", 100 * fact.value), fmt::arg("limit_percent", 100 * fact.limit),
      fmt::arg("value_length", length_text(fact.value)),
      fmt::arg("limit_length", length_text(fact.limit)), fmt::arg("inverse", 1 / fact.value),
      fmt::arg("deficit_percent", -100 * fact.value), fmt::arg("unit", fact.slides ? "m" : "rad"),
      fmt::arg("effort_unit", fact.slides ? "N" : "N·m"));
}

void check(const simulate::Fact& fact, Context& context) {
  const Row& row = row_of<simulate::Fact>(fact, kTables);
  std::string message = message_of(fact, row);
  if (row.help.empty() && !fact.test.empty()) {
    const bool several = fact.test.find(" and ") != std::string::npos;
    message += (several ? ", in the tests " : ", in the test ") + fact.test;
  }
  // Of limits that leave zero out, a robot has as many as joints: they are written by one hand.
  const bool is_start = fact.kind == simulate::FactKind::kStartMoved;
  context.report({.where = fact.where,
                  .message = std::move(message),
                  .subject = fact.subject,
                  .help = fact.help.empty() ? std::string(row.help) : fact.help,
                  .cause = is_start ? "zero is outside its limits" : ""});
}

}  // namespace simulation

std::vector<Rule> simulate_rules() {
  return rules_of<simulate::Fact>(simulation::kTables, simulation::check);
}

}  // namespace rigor::rules
