// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_cause_mesh_missing {

void check(const simulate::Fact& fact, Context& context) {
  context.report(stated(fact,
                        fmt::format("lacks {:.0f} of its {:.0f} collisions, whose meshes could not "
                                    "be read",
                                    fact.value, fact.limit),
                        "put the files where the URIs lead"));
}

Rule rule() {
  return {
      .name = "simulate-cause-mesh-missing",
      .category = Category::kSimulate,
      .severity = Severity::kWarning,
      .summary = "a model lacks collisions whose meshes could not be read",
      .why =
          "How it stands, and what it touches, is not known without them. So what a run shows of "
          "that is "
          "a warning at most.",
      .what_to_do =
          "Put the files where the URIs lead; `rigor resolve URI` lists every place that was "
          "tried.",
      .checks = {on_simulation({simulate::FactKind::kCauseMeshMissing}, check)},
  };
}

}  // namespace rigor::rules::simulate_cause_mesh_missing
