// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/simulate.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include <rigor/process/child.h>
#include <rigor/simulate/advice.h>
#include <rigor/simulate/assertion.h>
#include <rigor/simulate/confirm.h>
#include <rigor/simulate/metric_parts.h>
#include <rigor/simulate/stage.h>

namespace rigor::simulate {
namespace {

/// A scenario of a task with settings, to be run in a child.
struct RunOrder {
  const Task* task = nullptr;
  const Scenario* scenario = nullptr;
  SolverSettings settings;
};

std::string run_and_encode(const RunOrder& order) {
  return encode(run(stage(order.task->scene, *order.scenario), *order.scenario, order.settings));
}

/// Runs and counts them for the caller, over several batches.
class RunQueue {
 public:
  explicit RunQueue(const SimulateOptions& options) : options_(options) {}

  std::vector<Record> run_all(const std::vector<RunOrder>& orders) {
    std::vector<std::function<std::string()>> works;
    for (const RunOrder& order : orders) {
      works.push_back([&order] { return run_and_encode(order); });
    }
    total_ += works.size();
    const auto tell = [&](std::size_t done) {
      if (options_.progress) options_.progress(before_ + done, total_);
    };
    std::vector<Record> records;
    for (const process::ChildResult& result :
         process::run_in_children(kRunLimits, works, options_.jobs, tell)) {
      records.push_back(record_of(result));
    }
    before_ = total_;
    return records;
  }

 private:
  const SimulateOptions& options_;
  std::size_t before_ = 0;  // of earlier batches
  std::size_t total_ = 0;
};

/// A run of a task, and the task.
struct TaskRun {
  const Task* task = nullptr;
  Run run;
};

Run judged_run(const RunOrder& order, Record record) {
  Run run{.test = order.scenario->name, .seed = order.settings.seed, .scenario = *order.scenario};
  run.metrics = metrics_of(order.task->scene, *order.scenario, record, order.task->wheels);
  run.record = std::move(record);
  if (was_stopped(run.record)) run.verdict = Verdict::kInvalid;
  return run;
}

bool to_be_confirmed(const Run& run) {
  return run.verdict == Verdict::kInvalid ||
         std::any_of(run.metrics.begin(), run.metrics.end(),
                     [](const Metric& metric) { return metric.verdict == Verdict::kFail; });
}

void add_difference(const Scene& scene, std::string_view id, double difference, Run& run) {
  if (!(difference < kInfinity)) return;
  Fact about = about_scene(scene);
  about.test = run.test;
  run.metrics.push_back(make_metric(id, difference, std::move(about)));
}

void add_comparison(const Scene& scene, std::string_view id, const Record& other, Run& run) {
  add_difference(scene, id, difference_of(scene, run.record, other), run);
}

/// A run that failed, and those that it was held against so far.
struct Doubted {
  TaskRun* one = nullptr;
  std::vector<Variant> variants;
  std::vector<Again> agains;
};

void add_comparisons(const Doubted& doubted) {
  const Scene& scene = doubted.one->task->scene;
  Run& run = doubted.one->run;
  const std::vector<Again>& agains = doubted.agains;
  add_comparison(scene, "dt.sensitivity", agains[kHalfStep].record, run);
  add_comparison(scene, "solver.agreement", agains[kOtherSolver].record, run);
  if (agains.size() <= kOtherSolver + 1) return;
  double spread = 0;
  for (std::size_t seed = kOtherSolver + 1; seed < agains.size(); ++seed) {
    spread = std::max(spread, difference_of(scene, run.record, agains[seed].record));
  }
  add_difference(scene, "seed.spread", spread, run);
}

void confirm_failures(RunQueue& queue, std::vector<TaskRun>& runs) {
  std::vector<Doubted> all;
  for (TaskRun& one : runs) {
    if (!to_be_confirmed(one.run)) continue;
    all.push_back({&one, variants_of(settings_in(one.run.scenario, one.task->solver)), {}});
  }
  while (true) {
    std::vector<RunOrder> orders;
    std::vector<Doubted*> whose;
    for (Doubted& doubted : all) {
      const std::size_t first = doubted.agains.size();
      const std::size_t count = next_of(doubted.agains, doubted.one->run);
      for (std::size_t i = first; i < first + count; ++i) {
        const SolverSettings& settings = doubted.variants[i].settings;
        orders.push_back({doubted.one->task, &doubted.one->run.scenario, settings});
        whose.push_back(&doubted);
      }
    }
    if (orders.empty()) break;
    std::vector<Record> records = queue.run_all(orders);
    for (std::size_t i = 0; i < whose.size(); ++i) {
      const Task& task = *orders[i].task;
      Doubted& doubted = *whose[i];
      Again again{doubted.variants[doubted.agains.size()], std::move(records[i]), {}, false};
      again.metrics = metrics_of(task.scene, *orders[i].scenario, again.record, task.wheels);
      again.stopped = was_stopped(again.record);
      doubted.agains.push_back(std::move(again));
    }
  }
  for (const Doubted& doubted : all) {
    confirm(doubted.agains, doubted.one->run);
    add_comparisons(doubted);
  }
}

/// Two facts with the same are told once.
using FactKey = std::tuple<FactKind, std::string_view, std::string_view>;

FactKey key_of(const Fact& fact) { return {fact.kind, fact.subject, fact.name}; }

void add_once(Facts& facts, const Fact& fact, const std::string& test) {
  const auto same = [&](const Fact& other) { return key_of(other) == key_of(fact); };
  if (std::any_of(facts.begin(), facts.end(), same)) return;
  facts.push_back(fact);
  facts.back().test = test;
}

/// The verdict, and what is to be said about it, each fact with what is likely to be behind it.
void conclude_run(const Scene& scene, const Facts& causes, Run& run) {
  if (was_stopped(run.record)) {
    Fact refused{.kind = FactKind::kEngineRefused, .name = run.record.message, .test = run.test};
    refused.subject = scene.name;
    refused.severe = run.verdict == Verdict::kInvalid;
    run.facts.push_back(std::move(refused));
  }
  for (const Metric& metric : run.metrics) {
    run.verdict = worse(run.verdict, metric.verdict);
    if (!metric.fact) continue;
    run.facts.push_back(*metric.fact);
    for (const Fact& cause : explain(*metric.fact, causes)) add_once(run.facts, cause, run.test);
  }
  for (Fact& broken : broken_assertions(scene, run.scenario, run.record, run.metrics)) {
    run.verdict = worse(run.verdict, Verdict::kFail);
    run.facts.push_back(std::move(broken));
  }
}

/// What is plainly wrong is worth a word even where no run showed it: such causes come first.
void add_unexplained(const Facts& causes, Simulation& simulation) {
  if (simulation.runs.empty()) return;
  std::set<FactKey> told;
  for (const Run& run : simulation.runs) {
    for (const Fact& fact : run.facts) told.insert(key_of(fact));
  }
  Facts alone;
  for (const Fact& cause : causes) {
    if (!cause.severe || !told.insert(key_of(cause)).second) continue;
    alone.push_back(cause);
    alone.back().test.clear();
    alone.back().severe = false;  // nothing failed by it
  }
  if (alone.empty()) return;
  Run& first = simulation.runs.front();
  first.facts.insert(first.facts.begin(), alone.begin(), alone.end());
  first.verdict = worse(first.verdict, Verdict::kWarn);
}

}  // namespace

Verdict worse(Verdict a, Verdict b) {
  const auto rank = [](Verdict verdict) {
    switch (verdict) {
      case Verdict::kPass: return 0;
      case Verdict::kWarn: return 1;
      case Verdict::kSolver: return 2;
      case Verdict::kFail: return 3;
      case Verdict::kInvalid: return 4;
    }
    return 4;
  };
  return rank(a) < rank(b) ? b : a;
}

std::vector<Simulation> simulate(const std::vector<Task>& tasks, const SimulateOptions& options) {
  std::vector<RunOrder> orders;
  for (const Task& task : tasks) {
    for (const Scenario& scenario : task.scenarios) {
      orders.push_back({&task, &scenario, settings_in(scenario, task.solver)});
    }
  }
  RunQueue queue(options);
  std::vector<Record> records = queue.run_all(orders);
  std::vector<TaskRun> runs;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    runs.push_back({orders[i].task, judged_run(orders[i], std::move(records[i]))});
  }
  if (options.confirm == Confirm::kFailures) confirm_failures(queue, runs);
  std::vector<Simulation> simulations(tasks.size());
  for (TaskRun& one : runs) {
    conclude_run(one.task->scene, one.task->causes, one.run);
    simulations[static_cast<std::size_t>(one.task - tasks.data())].runs.push_back(
        std::move(one.run));
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    add_unexplained(tasks[i].causes, simulations[i]);
    for (const Run& run : simulations[i].runs) {
      simulations[i].verdict = worse(simulations[i].verdict, run.verdict);
    }
  }
  return simulations;
}

}  // namespace rigor::simulate
