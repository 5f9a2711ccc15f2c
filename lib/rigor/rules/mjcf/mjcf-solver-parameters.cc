// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <string_view>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/read/mjcf/mjcf_settings.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_solver_parameters {

/// Of one that is as stiff as the time step allows little is lost.
bool is_time_constant(std::string_view name, std::string_view text) {
  const auto n = read::mjcf_numbers(text);
  if (!n || n->empty() || name.find("solref") == name.npos) return false;
  return (*n)[0] > 0 && (n->size() < 2 || (*n)[1] > 0);
}

void check(const read::MjcfFact& fact, Context& context) {
  const bool stiff = is_time_constant(fact.name, context.bytes(fact.where));
  context.report({.where = fact.where,
                  .message = fact.name + " " + fact.detail,
                  .subject = fact.subject,
                  .severity = stiff ? std::optional(Severity::kInfo) : std::nullopt});
}

Rule rule() {
  return {
      .name = "mjcf-solver-parameters",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "solver parameters that MuJoCo does not take as they are",
      .why = "MuJoCo loads the model, and uses other values than those that are written, "
             "so that contacts and limits are softer or harder than meant.",
      .what_to_do = "Write two positive or two negative numbers for solref, a time constant of "
                    "at least two time steps, and impedances between 0 and 1 that do not fall.",
      .checks = {on_mjcf({read::MjcfFactKind::kSolver}, check)},
  };
}

}  // namespace rigor::rules::mjcf_solver_parameters
