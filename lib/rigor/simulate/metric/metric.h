// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers that say whether a run went as a sane robot's does, each with the limits beyond which it is a
// warning and a failure. Where the limits come from stands in docs/simulate.md.
//
//   for (const Metric& metric : metrics_of(scene, scenario, record, wheels)) print(metric.id);

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/simulate/fact.h>
#include <rigor/simulate/run.h>
#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>
#include <rigor/simulate/wheels.h>

namespace rigor::simulate {

enum class Verdict : std::uint8_t { kPass, kWarn, kFail, kSolver, kInvalid };

/// "pass", "warn", "fail", "solver", "invalid".
std::string_view to_string(Verdict verdict);

struct Metric {
  std::string_view id;  ///< "tilt.max"
  double value = 0;
  std::string_view unit;       ///< "rad"; empty for a ratio
  std::optional<double> warn;  ///< beyond it (above, unless the id's table says below)
  std::optional<double> fail;
  Verdict verdict = Verdict::kPass;
  /// What it shows when it is no pass: kind, subject and place of the worst element.
  std::optional<Fact> fact;
};

/// In a fixed order. `wheels` may be empty for tests that do not drive.
std::vector<Metric> metrics_of(const Scene& scene, const Scenario& scenario, const Record& record,
                               const DriveTrain& wheels);

}  // namespace rigor::simulate
