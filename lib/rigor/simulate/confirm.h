// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a failure is the model's or the solver's: the same run again with other settings, and what
// most of the runs show. For sources of this room.
//
//   const std::vector<Variant> variants = variants_of(settings);
//   std::vector<Again> agains;
//   while (const std::size_t count = next_of(agains, run)) run_next(variants, count, agains);
//   confirm(agains, run);

#pragma once

#include <string>
#include <vector>

#include <rigor/simulate/simulate.h>

namespace rigor::simulate {

struct Variant {
  std::string what;  ///< "half the step", "dantzig", "seed 1"
  SolverSettings settings;
};

/// Half the step, the other solver, and two other seeds of the iterative one, in this order.
inline constexpr std::size_t kHalfStep = 0;
inline constexpr std::size_t kOtherSolver = 1;
inline constexpr std::size_t kVariants = 4;
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

/// How many of the variants that are left to run at once; 0 when the rest could change no verdict. Half
/// the step and the other solver come first; seeds, one at a time, where those two disagree.
std::size_t next_of(const std::vector<Again>& agains, const Run& run);

/// Writes the confirmations into the run. A metric whose failure most of the runs do not share becomes
/// `solver`, with a fact of kind kSolverDiffers that names it; the same for a run that was stopped. One
/// that took too long, where the run itself did not, has no say.
void confirm(const std::vector<Again>& agains, Run& run);

/// How far the ends of two runs are apart: of models' bases, as a share of the scene's size or of the
/// way, whichever is longer. Infinite when one has no end.
double difference_of(const Scene& scene, const Record& a, const Record& b);

}  // namespace rigor::simulate
