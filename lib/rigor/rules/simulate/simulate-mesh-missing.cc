// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_mesh_missing {

void check(const simulate::Fact& fact, Context& context) {
  context.report(
      shown(fact, "the mesh of a collision could not be read: the simulation goes on without it"));
}

Rule rule() {
  return {
      .name = "simulate-mesh-missing",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a collision's mesh could not be read",
      .why =
          "The collision was left out, so what it should touch goes through it. A simulator "
          "does the same, or refuses the model.",
      .what_to_do =
          "Put the file where the URI leads; `rigor resolve URI` lists every place that was "
          "tried.",
      .checks = {on_simulation({simulate::FactKind::kMeshMissing}, check)},
  };
}

}  // namespace rigor::rules::simulate_mesh_missing
