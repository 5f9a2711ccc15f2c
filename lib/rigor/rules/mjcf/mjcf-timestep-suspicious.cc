// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_timestep_suspicious {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where, .message = "timestep " + fact.detail, .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-timestep-suspicious",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "time step that is not positive or large",
      .why = "MuJoCo loads the model, and the simulation stands still, runs backward or "
             "becomes unstable: contacts need some steps, and its default is 0.002 s.",
      .what_to_do = "Write a time step of a few milliseconds.",
      .checks = {on_mjcf({read::MjcfFactKind::kTimestep}, check)},
  };
}

}  // namespace rigor::rules::mjcf_timestep_suspicious
