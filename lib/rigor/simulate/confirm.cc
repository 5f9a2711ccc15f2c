// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/confirm.h>

#include <algorithm>
#include <array>
#include <string_view>

#include <rigor/simulate/metric/parts.h>

namespace rigor::simulate {
namespace {

/// What a motor or a contact leaks that is not solved to the end.
bool is_of_rest(const Metric& metric) {
  constexpr std::array<std::string_view, 6> kIds{"settle.time",   "rest.residual_v",
                                                 "rest.creep",    "rest.yaw_creep",
                                                 "rest.contacts", "joint.jitter"};
  return std::find(kIds.begin(), kIds.end(), metric.id) != kIds.end();
}

/// Or a joint that comes a little apart, and jumps.
bool is_of_convergence(const Metric& metric) {
  return is_of_rest(metric) || metric.id == "accel.peak" || metric.id == "energy.gain" ||
         metric.id == "joint.anchor_error";
}

bool is_doubtful(const Metric& metric) {
  return metric.verdict == Verdict::kWarn && is_of_convergence(metric);
}

bool fails(const std::vector<Metric>& metrics, const Metric& same) {
  return std::any_of(metrics.begin(), metrics.end(), [&](const Metric& metric) {
    return metric.id == same.id && metric.verdict == Verdict::kFail;
  });
}

bool came_apart(const Record& record) {
  return record.end == Record::End::kNotFinite || record.end == Record::End::kFarAway;
}

/// A run that was stopped, or that came apart, shows no less than a failure that comes later.
bool shows(const Again& again, const Metric& failure) {
  return again.stopped || came_apart(again.record) || fails(again.metrics, failure);
}

/// The exact solver's time grows with the cube of the contacts: what it did not get to, it did not see.
bool is_in_time(const Again& again, const Run& run) {
  return again.record.end != Record::End::kOutOfTime || was_stopped(run.record);
}

/// The exact solver comes apart on contacts that the iterative one takes.
bool has_a_say(const Again& again, const Run& run) {
  return is_in_time(again, run) && (!came_apart(again.record) || came_apart(run.record));
}

/// What the runs of a failure say, the first among those that show it. Two that agree are enough.
struct Votes {
  std::size_t showing = 1;
  std::size_t lacking = 0;

  bool open() const { return showing < 2 && lacking < 2; }
  bool denied() const { return lacking > showing; }
  bool disputed() const { return showing > 1 && lacking > 0; }
};

template <class Shows>
Votes votes_of(const std::vector<Again>& agains, const Run& run, const Shows& shows_it) {
  Votes votes;
  for (const Again& again : agains) {
    if (!has_a_say(again, run) || !votes.open()) continue;
    ++(shows_it(again) ? votes.showing : votes.lacking);
  }
  return votes;
}

Votes votes_for(const std::vector<Again>& agains, const Run& run, const Metric& failure) {
  return votes_of(agains, run, [&](const Again& again) { return shows(again, failure); });
}

bool is_exact(const Again& again) {
  return again.variant.other == Variant::Other::kSolver &&
         again.variant.settings.solver == Solver::kDantzig;
}

/// The exact solver's metric of a run that came to its end, where it is not as bad; null otherwise.
const Metric* better_exact(const Again& again, const Metric& metric) {
  if (!is_exact(again) || again.record.end != Record::End::kDone) return nullptr;
  const auto exact = std::find_if(again.metrics.begin(), again.metrics.end(),
                                  [&](const Metric& other) { return other.id == metric.id; });
  const bool is_better = exact != again.metrics.end() && exact->verdict < metric.verdict;
  return is_better ? &*exact : nullptr;
}

/// Whether the exact solver is to have its word: on warnings in doubt, and on failures of rest. Half the step shares the
/// iterative solver. What flies apart with most runs is no matter of convergence.
bool is_for_exact(const Metric& metric) {
  return is_doubtful(metric) || (metric.verdict == Verdict::kFail && is_of_rest(metric));
}

const Metric* exact_instead(const std::vector<Again>& agains, const Metric& metric) {
  if (!is_for_exact(metric)) return nullptr;
  for (const Again& again : agains) {
    if (const Metric* exact = better_exact(again, metric)) return exact;
  }
  return nullptr;
}

Votes votes_for_stop(const std::vector<Again>& agains, const Run& run) {
  return votes_of(agains, run, [](const Again& again) { return again.stopped; });
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
  using Other = Variant::Other;
  if (settings.engine == EngineKind::kMujoco) {
    std::vector<Variant> finer{{Other::kStep, "half the step", settings},
                               {Other::kQuarter, "a quarter of the step", settings}};
    finer[0].settings.step /= 2;
    finer[1].settings.step /= 4;
    return finer;
  }
  const bool quick = settings.solver == Solver::kQuick;
  Variant solver{Other::kSolver, quick ? "dantzig" : "quick", settings};
  solver.settings.solver = quick ? Solver::kDantzig : Solver::kQuick;
  Variant half{Other::kStep, "half the step", settings};
  half.settings.step /= 2;
  std::vector<Variant> variants{quick ? solver : half, quick ? half : solver};
  for (std::uint64_t i = 1; i <= 2; ++i) {
    // Dantzig's does not draw numbers: seeds are those of the iterative solver.
    Variant seeded{Other::kSeed, "seed " + std::to_string(settings.seed + i), settings};
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

bool has_doubtful_warning(const Run& run, const SolverSettings& settings) {
  return settings.engine == EngineKind::kOde && settings.solver == Solver::kQuick &&
         std::any_of(run.metrics.begin(), run.metrics.end(), is_doubtful);
}

Next next_of(const std::vector<Again>& agains, const Run& run) {
  const std::size_t most = run.engine == EngineKind::kMujoco ? kMujocoVariants : kVariants;
  if (agains.size() >= most) return Next::kNone;
  const bool any_open =
      (was_stopped(run.record) && votes_for_stop(agains, run).open()) ||
      std::any_of(run.metrics.begin(), run.metrics.end(), [&](const Metric& metric) {
        return metric.verdict == Verdict::kFail && votes_for(agains, run, metric).open() &&
               exact_instead(agains, metric) == nullptr;
      });
  // The exact solver is the first of the variants.
  const bool any_doubtful =
      agains.empty() && std::any_of(run.metrics.begin(), run.metrics.end(), is_doubtful);
  // Where the other solver and half the step disagree a seed says how much is chance. It changes no verdict.
  const bool any_disputed =
      agains.size() == 2 &&
      std::any_of(run.metrics.begin(), run.metrics.end(), [&](const Metric& metric) {
        return metric.verdict == Verdict::kFail && votes_for(agains, run, metric).disputed();
      });
  return any_open || any_doubtful || any_disputed ? Next::kVariant : Next::kNone;
}

void confirm(const std::vector<Again>& agains, Run& run) {
  const bool stopped = was_stopped(run.record);
  run.confirmations.clear();
  for (const Again& again : agains) {
    Confirmation confirmation{.what = again.variant.what,
                              .agrees = stopped && again.stopped,
                              .in_time = is_in_time(again, run)};
    for (const Metric& metric : again.metrics) {
      confirmation.verdict = worse(confirmation.verdict, metric.verdict);
    }
    if (again.stopped) confirmation.verdict = Verdict::kInvalid;
    for (const Metric& metric : run.metrics) {
      if (!has_a_say(again, run)) continue;
      const bool is_asked = is_exact(again) && is_for_exact(metric);
      if (metric.verdict != Verdict::kFail && !is_asked) continue;
      if (is_asked ? better_exact(again, metric) == nullptr : shows(again, metric)) {
        confirmation.agrees = true;
      } else {
        confirmation.lacking.push_back(metric.id);
      }
    }
    run.confirmations.push_back(std::move(confirmation));
  }
  for (Metric& metric : run.metrics) {
    if (const Metric* exact = exact_instead(agains, metric)) {
      metric = *exact;
    } else if (metric.verdict == Verdict::kFail && votes_for(agains, run, metric).denied()) {
      blame_solver(metric);
    }
  }
  if (!stopped) return;
  run.verdict = votes_for_stop(agains, run).denied() ? Verdict::kSolver : Verdict::kInvalid;
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
