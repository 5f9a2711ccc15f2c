// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/confirm.h>

#include <algorithm>

#include <rigor/simulate/metric_parts.h>

namespace rigor::simulate {
namespace {

bool fails(const std::vector<Metric>& metrics, const Metric& same) {
  return std::any_of(metrics.begin(), metrics.end(), [&](const Metric& metric) {
    return metric.id == same.id && metric.verdict == Verdict::kFail;
  });
}

/// A run that was stopped, or that exploded, shows no less than a failure that comes later.
bool shows(const Again& again, const Metric& failure) {
  return again.stopped || fails(again.metrics, failure) ||
         again.record.end == Record::End::kNotFinite || again.record.end == Record::End::kFarAway;
}

/// Most of all runs, the first among them.
bool most_lack_it(std::ptrdiff_t showing, std::size_t confirmations) {
  return static_cast<std::ptrdiff_t>(confirmations) - showing > showing + 1;
}

void blame_solver(Metric& metric) {
  metric.verdict = Verdict::kSolver;
  if (!metric.fact) return;
  metric.fact->kind = FactKind::kSolverDiffers;
  metric.fact->name = metric.id;
  metric.fact->severe = false;
}

}  // namespace

std::vector<Variant> variants_of(const SolverSettings& settings) {
  const bool quick = settings.solver == Solver::kQuick;
  std::vector<Variant> variants{{"half the step", settings},
                                {quick ? "dantzig" : "quick", settings}};
  variants[0].settings.step /= 2;
  variants[1].settings.solver = quick ? Solver::kDantzig : Solver::kQuick;
  for (std::uint64_t i = 1; i <= 2; ++i) {
    // Dantzig's does not draw numbers: seeds are those of the iterative solver.
    Variant seeded{"seed " + std::to_string(settings.seed + i), settings};
    seeded.settings.solver = Solver::kQuick;
    seeded.settings.seed += i;
    variants.push_back(std::move(seeded));
  }
  return variants;
}

bool was_stopped(const Record& record) {
  return record.end == Record::End::kRefused || record.end == Record::End::kCrashed ||
         record.end == Record::End::kOutOfTime;
}

void confirm(const std::vector<Again>& agains, Run& run) {
  const bool stopped = was_stopped(run.record);
  run.confirmations.clear();
  for (const Again& again : agains) {
    Confirmation confirmation{again.variant.what, Verdict::kPass, stopped && again.stopped};
    for (const Metric& metric : again.metrics) {
      confirmation.verdict = worse(confirmation.verdict, metric.verdict);
    }
    if (again.stopped) confirmation.verdict = Verdict::kInvalid;
    for (const Metric& metric : run.metrics) {
      const bool same = metric.verdict == Verdict::kFail && shows(again, metric);
      confirmation.agrees = confirmation.agrees || same;
    }
    run.confirmations.push_back(std::move(confirmation));
  }
  for (Metric& metric : run.metrics) {
    if (metric.verdict != Verdict::kFail) continue;
    const auto showing = std::count_if(agains.begin(), agains.end(),
                                       [&](const Again& again) { return shows(again, metric); });
    if (most_lack_it(showing, agains.size())) blame_solver(metric);
  }
  if (!stopped) return;
  const auto also =
      std::count_if(agains.begin(), agains.end(), [](const Again& again) { return again.stopped; });
  const bool by_solver = most_lack_it(also, agains.size());
  run.verdict = by_solver ? Verdict::kSolver : Verdict::kInvalid;
}

double difference_of(const Scene& scene, const Record& a, const Record& b) {
  if (a.end != Record::End::kDone || b.end != Record::End::kDone) return kInfinity;
  double largest = 0;
  for (const SceneModel& model : scene.models) {
    const std::uint32_t base = model.base;
    if (base >= a.final.bodies.size() || base >= b.final.bodies.size()) continue;
    const SceneBody& body = scene.bodies[base];
    const Vector3 start = transform(body.X_WB, body.mass.com);
    const Vector3& at = a.final.bodies[base].p_WBcm;
    const double way = std::max(scene.size, length(at - start));
    largest = std::max(largest, length(at - b.final.bodies[base].p_WBcm) / way);
  }
  return largest;
}

}  // namespace rigor::simulate
