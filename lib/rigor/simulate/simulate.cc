// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/simulate.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include <rigor/simulate/advice/advice.h>
#include <rigor/simulate/confirm.h>
#include <rigor/simulate/engine_comparison.h>
#include <rigor/simulate/metric/assertion.h>
#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/mount.h>
#include <rigor/simulate/stage.h>

namespace rigor::simulate {
namespace {

/// s: with less left nothing is begun. A worker's limit is in whole seconds.
constexpr double kMinBudget = 1;

/// A second of budget suffices for so many joints: a test of 1 s takes 7 ms of CPU time for each of them (a chain of
/// 2,000 hinges, 200 iterations), so that 1,000 of them take half of the default budget.
constexpr double kJointsOfBudget = 50;

/// A scenario of a task with settings, to be run in a worker.
struct RunOrder {
  const Task* task = nullptr;
  const Scenario* scenario = nullptr;
  SolverSettings settings;
};

/// Whether the exact solver, which nobody asked for, left steps unsolved: all stands still in those.
bool gave_up(const RunOrder& order, const Record& record) {
  return record.solver_messages > 0 && order.settings.engine == EngineKind::kOde &&
         order.settings.solver == Solver::kDantzig && order.task->solver.solver == Solver::kQuick;
}

process::Request request_of(const RunOrder& order) {
  return run_request(stage(order.task->scene, *order.scenario), *order.scenario, order.settings);
}

std::vector<Metric> metrics_in(const Task& task, const Scenario& scenario, const Record& record) {
  if (scenario.base == Base::kFree) return metrics_of(task.scene, scenario, record, task.wheels);
  return metrics_of(mounted(task.scene, scenario.base), scenario, record, task.wheels);
}

Run judged_run(const RunOrder& order, Record record) {
  Run run{.test = order.scenario->name,
          .seed = order.settings.seed,
          .engine = order.settings.engine,
          .scenario = *order.scenario};
  run.metrics = metrics_in(*order.task, *order.scenario, record);
  run.record = std::move(record);
  if (was_stopped(run.record)) run.verdict = Verdict::kInvalid;
  return run;
}

bool failed(const Run& run) {
  return run.verdict == Verdict::kInvalid ||
         std::any_of(run.metrics.begin(), run.metrics.end(),
                     [](const Metric& metric) { return metric.verdict == Verdict::kFail; });
}

/// After it was confirmed: whether what the other runs show of the way is worth telling.
bool is_failure_or_solvers(const Run& run) {
  return run.verdict == Verdict::kInvalid || run.verdict == Verdict::kSolver ||
         std::any_of(run.metrics.begin(), run.metrics.end(), [](const Metric& metric) {
           return metric.verdict == Verdict::kFail || metric.verdict == Verdict::kSolver;
         });
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

void add_comparisons(const Scene& scene, const std::vector<Again>& agains, Run& run) {
  std::optional<double> spread;
  for (const Again& again : agains) {
    switch (again.variant.other) {
      case Variant::Other::kStep: add_comparison(scene, "dt.sensitivity", again.record, run); break;
      case Variant::Other::kSolver:
        add_comparison(scene, "solver.agreement", again.record, run);
        break;
      case Variant::Other::kQuarter: break;
      case Variant::Other::kSeed:
        spread = std::max(spread.value_or(0), difference_of(scene, run.record, again.record));
        break;
    }
  }
  if (spread) add_difference(scene, "seed.spread", *spread, run);
}

/// Two facts with the same are reported once.
using FactKey = std::tuple<FactKind, std::string_view, std::string_view>;

FactKey key_of(const Fact& fact) { return {fact.kind, fact.subject, fact.name}; }

/// What nobody had time to confirm is not called a failure.
void call_unconfirmed(Run& run) {
  for (Metric& metric : run.metrics) {
    if (metric.verdict != Verdict::kFail) continue;
    metric.verdict = Verdict::kWarn;
    metric.fact->severe = false;
  }
}

/// The verdict, and what is to be said about it, each fact with what is likely to be behind it: a cause of several is reported
/// with each.
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
    for (Fact& cause : explain(*metric.fact, causes)) {
      cause.test = run.test;
      run.facts.push_back(std::move(cause));
    }
  }
  for (Fact& broken : broken_assertions(scene, run.scenario, run.record, run.metrics)) {
    run.verdict = worse(run.verdict, Verdict::kFail);
    run.facts.push_back(std::move(broken));
  }
  if (run.engine == EngineKind::kOde) return;
  for (Fact& fact : run.facts) fact.test = run.test + " (MuJoCo)";
}

/// A model of another size than its masses: whatever the runs show, and however solvers differ on it, it is not the robot
/// that its file describes.
bool is_another_robot(const Fact& cause) { return cause.kind == FactKind::kCauseMeshScale; }

/// What is plainly wrong is worth a word even where no run showed it: such causes come first.
void add_unexplained(const Facts& causes, Simulation& simulation) {
  if (simulation.runs.empty()) return;
  std::set<FactKey> told;
  for (const Run& run : simulation.runs) {
    for (const Fact& fact : run.facts) told.insert(key_of(fact));
  }
  Facts alone;
  for (const Fact& cause : causes) {
    const bool is_new = told.insert(key_of(cause)).second;
    if (!cause.severe || !(is_new || is_another_robot(cause))) continue;
    alone.push_back(cause);
    alone.back().test.clear();
    alone.back().severe = is_another_robot(cause);  // else nothing failed by it
  }
  if (alone.empty()) return;
  Run& first = simulation.runs.front();
  first.facts.insert(first.facts.begin(), alone.begin(), alone.end());
  const bool fails = std::any_of(alone.begin(), alone.end(), is_another_robot);
  first.verdict = worse(first.verdict, fails ? Verdict::kFail : Verdict::kWarn);
}

/// A run on its way, and what it is held against when it failed.
struct TaskRun {
  RunOrder order;
  std::size_t task = 0;
  Run run;
  std::vector<Variant> variants;  ///< none when it is believed
  std::vector<Again> agains;      ///< of the first variants; the last may be on its way
  std::string left_out;           ///< why there was no time for it
  bool unconfirmed = false;       ///< or none to confirm it
  bool failed = false;            ///< or was stopped, as it ran first
};

/// Runs what the tasks ask for, and hands over each task when the last of its runs is believed.
class Runs {
 public:
  using Done = std::function<void(std::size_t, Simulation)>;

  Runs(const std::vector<Task>& tasks, const SimulateOptions& options,
       const process::Workers& workers, const Done& done)
      : tasks_(tasks), options_(options), workers_(workers), done_(done) {}

  void run_all() {
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      const Task& task = tasks_[i];
      first_.push_back(runs_.size());
      left_.push_back(task.scenarios.size() * task.engines.size());
      spent_.push_back(0);
      const std::string too_large = why_too_large(task.scene);
      for (const Scenario& scenario : task.scenarios) {
        for (const EngineKind engine : task.engines) {
          if (too_large.empty()) waiting_.push_back({runs_.size(), std::nullopt});
          RunOrder order{&task, &scenario, settings_in(scenario, task.solver)};
          order.settings.engine = engine;
          runs_.push_back({std::move(order), i, {}, {}, {}, too_large, false, false});
          if (!too_large.empty()) --left_[i];
        }
      }
    }
    total_ = waiting_.size();
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      if (left_[i] == 0) hand_over(i);
    }
    workers_.feed(
        options_.jobs, [this] { return next(); },
        [this](std::size_t number, const process::RequestResult& result) {
          ended(number, result);
        });
  }

 private:
  /// A run as it was asked for, or one of its variants.
  struct Job {
    std::size_t run = 0;
    std::optional<std::size_t> variant;
  };

  std::optional<process::Request> next() {
    while (!waiting_.empty()) {
      const Job job = waiting_.front();
      waiting_.pop_front();
      const TaskRun& one = runs_[job.run];
      const double left = options_.budget - spent_[one.task];
      if (left < kMinBudget) {
        skip(job);
        continue;
      }
      started_.push_back(job);
      RunOrder order = one.order;
      if (job.variant) order.settings = one.variants[*job.variant].settings;
      process::Request request = request_of(order);
      if (left < request.limits.cpu_seconds) {
        request.limits.cpu_seconds = static_cast<unsigned>(left);
      }
      return request;
    }
    return std::nullopt;
  }

  /// The task has used up its time.
  void skip(const Job& job) {
    TaskRun& one = runs_[job.run];
    if (job.variant) {
      one.agains.pop_back();
      one.unconfirmed = true;
    } else {
      one.left_out = budget_words();
    }
    ++ended_;
    conclude(one);
  }

  /// Whether it was ended since no more time was left to its task.
  bool is_over_budget(const TaskRun& one, const Record& record) const {
    return record.end == Record::End::kOutOfTime && options_.budget - spent_[one.task] < kMinBudget;
  }

  void ended(std::size_t number, const process::RequestResult& result) {
    const Job job = started_[number];
    TaskRun& one = runs_[job.run];
    ++ended_;
    if (options_.progress) options_.progress(ended_, total_);
    if (options_.budget < kInfinity) {
      spent_[one.task] += cpu_seconds_of(result, options_.budget - spent_[one.task]);
    }
    Record record = record_of(result);
    if (is_over_budget(one, record)) {
      --ended_;  // skip counts it
      return skip(job);
    }
    if (job.variant) {
      one.agains[*job.variant] = again_of(one, *job.variant, std::move(record));
    } else if (gave_up(one.order, record)) {
      one.order.settings.solver = Solver::kQuick;
      ++total_;
      waiting_.push_front({job.run, std::nullopt});
      return;
    } else {
      one.run = judged_run(one.order, std::move(record));
      one.failed = failed(one.run);
      const bool is_open = one.failed || has_doubtful_warning(one.run, one.order.settings);
      if (options_.confirm == Confirm::kFailures && is_open) {
        one.variants = variants_of(one.order.settings);
      }
    }
    if (!one.variants.empty() && ask_again(job.run)) return;
    conclude(one);
  }

  static Again again_of(const TaskRun& one, std::size_t variant, Record record) {
    const Task& task = *one.order.task;
    Again again{one.variants[variant], std::move(record), {}, false};
    again.metrics = metrics_in(task, *one.order.scenario, again.record);
    again.stopped = was_stopped(again.record);
    return again;
  }

  /// Whether there is a variant that could change a verdict. They go before what has not begun.
  bool ask_again(std::size_t run) {
    TaskRun& one = runs_[run];
    const std::size_t first = one.agains.size();
    if (next_of(one.agains, one.run) == Next::kNone) return false;
    one.agains.emplace_back();
    ++total_;
    waiting_.push_front({run, first});
    return true;
  }

  void conclude(TaskRun& one) {
    const Task& task = *one.order.task;
    if (!one.variants.empty()) {
      confirm(one.agains, one.run);
      if (is_failure_or_solvers(one.run)) add_comparisons(task.scene, one.agains, one.run);
      one.agains.clear();  // trajectories
    }
    if (one.unconfirmed) call_unconfirmed(one.run);
    if (one.left_out.empty()) conclude_run(task.scene, task.causes, one.run);
    --left_[one.task];
    if (left_[one.task] == 0) hand_over(one.task);
  }

  void hand_over(std::size_t task) {
    Simulation simulation;
    const std::size_t count = tasks_[task].scenarios.size() * tasks_[task].engines.size();
    for (std::size_t i = 0; i < count; ++i) {
      TaskRun& one = runs_[first_[task] + i];
      const std::string& test = one.order.scenario->name;
      if (!one.left_out.empty()) {
        simulation.left_out.push_back(test + ": " + one.left_out);
        continue;
      }
      if (one.unconfirmed) {
        simulation.left_out.push_back(
            "confirmation of " + test + ": " + budget_words() +
            (one.failed ? "; its failures are warnings" : "; its warnings are the quick solver's"));
      }
      simulation.runs.push_back(std::move(one.run));
    }
    if (tasks_[task].engines.size() > 1) compare_engines(tasks_[task].scene, simulation);
    add_unexplained(tasks_[task].causes, simulation);
    for (const Run& run : simulation.runs) {
      simulation.verdict = worse(simulation.verdict, run.verdict);
    }
    done_(task, std::move(simulation));
  }

  /// What would use up the budget in its first test is not begun.
  std::string why_too_large(const Scene& scene) const {
    const double most = kJointsOfBudget * options_.budget;
    if (!(static_cast<double>(scene.joints.size()) > most)) return {};
    return std::to_string(scene.joints.size()) + " joints are more than the " +
           std::to_string(static_cast<long>(most)) + " that " + seconds_of_budget() +
           " suffice for (--budget 0 has no limit)";
  }

  std::string seconds_of_budget() const {
    return std::to_string(static_cast<long>(options_.budget)) + " s of CPU time";
  }

  std::string budget_words() const {
    return "over the budget of " + seconds_of_budget() + " (--budget)";
  }

  const std::vector<Task>& tasks_;
  const SimulateOptions& options_;
  const process::Workers& workers_;
  const Done& done_;
  std::vector<TaskRun> runs_;       // task by task
  std::vector<std::size_t> first_;  // of each task, among the runs
  std::vector<std::size_t> left_;   // of each task: runs to be concluded
  std::vector<double> spent_;       // of each task: s of CPU time
  std::deque<Job> waiting_;
  std::vector<Job> started_;
  std::size_t ended_ = 0;
  std::size_t total_ = 0;  // that are known of
};

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

std::vector<Simulation> simulate(const std::vector<Task>& tasks, const SimulateOptions& options,
                                 const process::Workers& workers) {
  std::vector<Simulation> simulations(tasks.size());
  simulate(tasks, options, workers, [&](std::size_t task, Simulation simulation) {
    simulations[task] = std::move(simulation);
  });
  return simulations;
}

void simulate(const std::vector<Task>& tasks, const SimulateOptions& options,
              const process::Workers& workers,
              const std::function<void(std::size_t, Simulation)>& done) {
  Runs(tasks, options, workers, done).run_all();
}

}  // namespace rigor::simulate
