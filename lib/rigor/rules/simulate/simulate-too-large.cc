// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_too_large {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("{}: {:.6g} is beyond the {:.6g} that can be simulated",
                                         fact.name, fact.value, fact.limit)));
}

Rule rule() {
  return {
      .name = "simulate-too-large",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "there is more than can be simulated",
      .why =
          "Bodies, shapes, joints and triangles are bounded, so that a broken file cannot take the "
          "machine along; so are places and sizes, since ODE ends the process on far-off ones.",
      .what_to_do =
          "Mend the number. Of too many things simulate a part (`--model`), or reduce the "
          "collision "
          "meshes with `rigor mesh-check --reduce`.",
      .checks = {on_simulation({simulate::FactKind::kTooLarge}, check)},
  };
}

}  // namespace rigor::rules::simulate_too_large
