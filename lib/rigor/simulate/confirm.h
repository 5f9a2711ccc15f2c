// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a failure is the model's or the solver's: the same run again with the other solver, and where that
// lacks it with half the step; in MuJoCo, whose solvers all solve the same, with a half and a quarter of it. What two of these three show is believed: seeds share the run's solver and
// its step, so they are asked only where one of the others has nothing to say.
//
// A warning is the iterative solver's where 200 iterations do not bring a chain to rest. Of what speaks of that the exact
// solver is asked once, and its word counts. For sources of this room.
//
//   const std::vector<Variant> variants = variants_of(settings);
//   std::vector<Again> agains;
//   while (const std::size_t count = next_of(agains, run)) run_next(variants, count, agains);
//   confirm(agains, run);

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/simulate/simulate.h>

namespace rigor::simulate {

struct Variant {
  enum class Other : std::uint8_t { kSolver, kStep, kQuarter, kSeed };
  Other other = Other::kSolver;
  std::string what;  ///< "dantzig", "half the step", "seed 1"
  SolverSettings settings;
};

/// The other solver and half the step (the exact solver's first, where the run had it), then two other seeds of
/// the iterative one. In MuJoCo half the step, then a quarter.
inline constexpr std::size_t kVariants = 4;
inline constexpr std::size_t kMujocoVariants = 2;
std::vector<Variant> variants_of(const SolverSettings& settings);

/// A run again, in other circumstances.
struct Again {
  Variant variant;
  Record record;
  std::vector<Metric> metrics;
  bool stopped = false;  ///< by the engine, a crash or a limit
};

/// Whether it did not come to its end, for reasons other than what moved.
bool was_stopped(const Record& record);

/// Whether the run only warns, of what an iterative solver may show that has not converged.
bool has_doubtful_warning(const Run& run, const SolverSettings& settings);

/// Whether the next of the variants could change a verdict, or say how much is chance.
enum class Next : std::uint8_t { kNone, kVariant };
Next next_of(const std::vector<Again>& agains, const Run& run);

/// Writes the confirmations into the run. A metric whose failure two runs lack, and not two of those with a
/// say show, becomes `solver`, with a fact of kind kSolverDiffers that names it; the same for a run that was
/// stopped. One that took too long, or that came apart where the run itself did not, has no say. A doubtful
/// warning or a failure of rest (speeds, jitter) that the exact solver lacks gives way to its metric.
void confirm(const std::vector<Again>& agains, Run& run);

/// How far the ends of two runs are apart: of models' bases, as a share of the scene's size or of the
/// way, whichever is longer. Infinite when one has no end.
double difference_of(const Scene& scene, const Record& a, const Record& b);

}  // namespace rigor::simulate
