// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The run as a whole: what no robot does, and what another run contradicts.

#include <cmath>
#include <span>

#include <rigor/rules/simulate/rows.h>

namespace rigor::rules::simulation {

using simulate::FactKind;

std::span<const Row> run_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"simulate-explodes", FactKind::kExplodes, Severity::kError},
       .message = "explodes: it is farther away than a thousand times its size, or nowhere",
       .summary = "the simulation explodes",
       .why = "A pose stopped being a number, or a body flew farther than a thousand times the "
              "model's size. In a simulator the model vanishes or takes the server with it.",
       .what_to_do =
           "Look at inertias far from those of the links' shapes, at links that overlap where the "
           "model begins, and at masses that differ by a factor of hundreds across a joint."},
      {.rule = {"simulate-too-fast", FactKind::kTooFast, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "accel.peak"
                        ? "accelerates with {value:.3g} g (limit {limit:.3g} g)"
                        : "moves {value:.3g} times as fast as falling by its own size and its "
                          "commands explain (limit {limit:.3g})";
           },
       .summary = "something moves faster than gravity and its motors could make it",
       .why = "A robot that is only set down, or driven gently, does not reach such speeds: "
              "contacts or joints push something apart.",
       .what_to_do = "Look for overlaps at the start (`rigor validate`), and for inertias that are "
                     "too small."},
      {.rule = {"simulate-energy-gained", FactKind::kEnergyGained, Severity::kError},
       .message =
           "gains {value:.3g} times the energy of lifting it by its own size (limit {limit:.3g})",
       .summary = "energy appears from nowhere",
       .why = "Nothing put it in: an overlap is pushed apart, a controller or spring is too stiff "
              "for the time step, or an inertia is not that of a rigid body.",
       .what_to_do = "Mend what overlaps at the start; give small links their true inertia; use a "
                     "smaller time step."},
      {.rule = {"simulate-step-sensitive", FactKind::kStepSensitive, Severity::kWarning},
       .message = "ends {value_percent:.3g} % of its path or size away with half the time step "
                  "(limit {limit_percent:.3g} %)",
       .summary = "half the time step gives another result",
       .why = "The model is at the edge of what can be computed with this step: small changes will "
              "break it.",
       .what_to_do = "Use a smaller `<max_step_size>`; look for stiff springs and small inertias."},
      {.rule = {"simulate-seed-sensitive", FactKind::kSeedSensitive, Severity::kWarning},
       .message = "ends {value_percent:.3g} % of its path or size away with another seed "
                  "(limit {limit_percent:.3g} %)",
       .summary = "another seed of the solver gives another result",
       .why = "The model is chaotic, or the solver does not converge on it: tests of it will be "
              "flaky.",
       .what_to_do =
           "Give the solver more iterations; look for redundant contacts and mass ratios."},
      {.rule = {"simulate-solver-differs", FactKind::kSolverDiffers, Severity::kWarning},
       .message =
           [](const simulate::Fact& fact) {
             return fact.name == "solver.agreement"
                        ? "ends in different places with Dantzig and quick-step, "
                          "{value_percent:.3g} % of its path or size apart (limit "
                          "{limit_percent:.3g} %)"
                        : "fails {name} with one solver only: other solvers, steps or seeds do "
                          "not show it";
           },
       .summary = "Dantzig and quick-step give different results",
       .why = "What was seen is as much the solver's doing as the model's; it is not called a "
              "failure of the model.",
       .what_to_do =
           "Try `--solver dantzig`, or more `--iterations`, and judge by what both agree on."},
      {.rule = {"simulate-engines-differ", FactKind::kEnginesDiffer, Severity::kWarning},
       .message = "{name}",
       .summary = "ODE and MuJoCo give different verdicts",
       .why = "A metric fails in one engine and not in the other, or the model ends elsewhere. The "
              "verdict depends on how the simulator models contacts, joints or meshes, so it may "
              "not carry over to the one you use.",
       .what_to_do = "Change what the finding names (a concave mesh, a restitution, a friction of "
                     "one direction), or judge the model in the engine it is for."},
      {.rule = {"simulate-assertion", FactKind::kAssertion, Severity::kError},
       .message =
           [](const simulate::Fact& fact) {
             return std::isnan(fact.value) ? "{name}: there is no such number in this run"
                                           : "{name}: it is {value:.6g}, beyond {limit:.6g}";
           },
       .summary = "an assertion of the scenario does not hold",
       .why = "The author of the scenario demanded it, and the model does not keep to it.",
       .what_to_do = "Mend the model, or the assertion."},
  };
  return kRows;
}

}  // namespace rigor::rules::simulation
