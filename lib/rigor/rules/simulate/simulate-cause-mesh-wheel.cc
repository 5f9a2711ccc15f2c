// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_mesh_wheel {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(fact, "the wheel collides as a mesh with flat sides",
                        "make its collision a cylinder"));
}

Rule rule() {
  return {
      .name = "simulate-cause-mesh-wheel",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a wheel collides as a mesh",
      .why =
          "A wheel of flat sides bounces and slips: 3 % of the way with 32 sides, 16 % with "
          "16.",
      .what_to_do =
          "Make its collision a cylinder: `rigor mesh-check FILE --fit cylinder` gives its "
          "size.",
      .checks = {on_simulation({simulate::FactKind::kCauseMeshWheel}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_mesh_wheel
