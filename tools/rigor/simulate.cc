// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor simulate`: models in tests, and what came of it.

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include <rigor/author/simulation.h>
#include <rigor/environment.h>
#include <rigor/read/load.h>
#include <rigor/report/printable.h>
#include <rigor/report/simulation.h>
#include <rigor/report/summary.h>

#include "command.h"
#include "model_file.h"
#include "output.h"
#include "progress.h"
#include "results_file.h"
#include "search.h"
#include "selection.h"
#include "simulation_options.h"

namespace rigor::tool {
namespace {

enum SimulationFormat : std::size_t { kPretty, kJson, kJsonl, kJunit, kCsv, kHtml };

/// So many cases are in memory at a time: their trajectories are let go when they are written.
constexpr std::size_t kChunk = 64;

class Simulate final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(
        program, "simulate", "Drop it, drive it, sweep its joints, and get a verdict",
        {"rigor simulate my_robot",
         "rigor simulate my_robot --test settle,drive,turn --output html:run.html",
         "rigor simulate arm.urdf --command elbow=position:1.5 --duration 3 --format csv",
         "rigor simulate robot.sdf --test drive --grid friction=0.2:1:9 --seeds 3 -j 4 --output "
         "jsonl:runs.jsonl"});
    app->add_option("paths", paths_, "Model files, or folders that hold models")
        ->type_name("MODEL");
    choices_.declare(*app);
    app->add_flag("--resume", resume_, "Skip the cases that the jsonl file holds already")
        ->group("Many runs");
    output_.declare(*app, {"pretty", "json", "jsonl", "junit", "csv", "html"});
    color_.declare(*app);
    selection_.declare(*app);
    search_.declare(*app);
    return app;
  }

  int run() override {
    const std::vector<Target> targets = output_.targets();
    const RealDisk disk;
    const Environment environment(disk, search_.paths());
    author::SimulationOptions options = choices_.options(disk);
    options.selection = selection_.selection();
    require_known(options.selection, environment.registry);
    CountProgress progress("runs");
    options.progress = [&progress](std::size_t done, std::size_t of) { progress.at(done, of); };
    const std::vector<simulate::Case> grid = choices_.cases(options.plan);

    Sources sources;
    read::Workspace workspace(disk, sources);
    const author::Simulator simulator(environment, sources, workspace, options);
    const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    std::deque<read::Loaded> loaded;
    std::deque<author::PreparedModel> models;
    for (const std::string& path : files(disk, options.plan)) {
      loaded.push_back(read::load(reader, open_model(workspace, path)));
      const auto positions = joint_positions(loaded.back().root, choices_.joints());
      models.push_back(simulator.prepare(loaded.back(), positions));
    }
    if (models.empty()) throw UsageError("there is no model to simulate");
    std::vector<const model::Root*> roots;
    for (const read::Loaded& file : loaded) roots.push_back(&file.root);
    require_model(options.scene.model, roots);
    return conclude(simulator, models, grid, targets, sources);
  }

 private:
  std::vector<std::string> files(const Disk& disk, const simulate::Plan& plan) {
    std::vector<std::string> named = paths_;
    if (named.empty()) named = choices_.models_of(plan);
    if (named.empty()) {
      throw UsageError("simulate needs a model; `rigor simulate --help` shows examples");
    }
    return model_paths(disk, named);
  }

  /// Every model at every point of the grid, but for those that are done or another shard's.
  std::vector<author::SimulationCase> cases(const std::deque<author::PreparedModel>& models,
                                            const std::vector<simulate::Case>& grid,
                                            const ResultsFile& results) const {
    const std::optional<Shard> shard = choices_.shard();
    std::vector<author::SimulationCase> cases;
    std::size_t index = 0;
    for (const author::PreparedModel& model : models) {
      for (simulate::Case one : grid) {
        one.index = index++;
        const bool ours = !shard || shard->has(model.loaded.file->path + ' ' + one.id);
        if (ours && !results.has(one.index)) cases.push_back({&model, std::move(one)});
      }
    }
    return cases;
  }

  int conclude(const author::Simulator& simulator, const std::deque<author::PreparedModel>& models,
               const std::vector<simulate::Case>& grid, const std::vector<Target>& targets,
               const Sources& sources) {
    ResultsFile results(results_file(targets), resume_);
    const std::vector<author::SimulationCase> all = cases(models, grid, results);
    const bool only_lines = std::all_of(targets.begin(), targets.end(), [](const Target& target) {
      return target.format == kJsonl;
    });
    std::vector<author::SimulatedModel> done;
    std::string lines;
    bool fails = false;
    for (std::size_t begin = 0; begin < all.size(); begin += kChunk) {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto count = static_cast<std::ptrdiff_t>(std::min(kChunk, all.size() - begin));
      for (author::SimulatedModel& result : simulator.run({first, first + count})) {
        refuse_problems(result);
        result.cases = models.size() * grid.size();
        fails = fails || selection_.fails(result.diagnostics);
        const std::string line = report::simulation_line(result, sources);
        results.add(line);
        lines += line;
        if (only_lines) drop_trajectories(result);
        done.push_back(std::move(result));
      }
    }
    const report::SimulationReport report{done, sources};
    for (const Target& target : targets) emit(target, report, lines);
    say(report::simulation_summary(report));
    return fails ? kFindings : kClean;
  }

  /// Where results are kept line by line: the file of `--output jsonl:FILE`.
  std::string results_file(const std::vector<Target>& targets) const {
    for (const Target& target : targets) {
      if (target.format == kJsonl && !target.file.empty()) return target.file;
    }
    if (resume_) throw UsageError("--resume goes with --output jsonl:FILE, which it reads");
    return {};
  }

  static void refuse_problems(const author::SimulatedModel& result) {
    if (result.problems.empty()) return;
    const simulate::PlanProblem& problem = result.problems.front();
    throw UsageError(
        result.path + ": there is no " + problem.what +
        did_you_mean(problem.name, {problem.candidates.begin(), problem.candidates.end()}));
  }

  static void drop_trajectories(author::SimulatedModel& result) {
    for (simulate::Run& run : result.simulation.runs) run.record = {};
  }

  void emit(const Target& target, const report::SimulationReport& report,
            const std::string& lines) const {
    switch (target.format) {
      case kPretty: return write(target, simulation_text(report, color_.of(target)));
      case kJson: return write(target, simulation_json(report));
      case kJsonl:
        if (target.file.empty()) write(target, lines);
        return;
      case kJunit: return write(target, simulation_junit(report));
      case kCsv: return write(target, simulation_csv(report));
      default: return write(target, simulation_html(report));
    }
  }

  std::vector<std::string> paths_;
  bool resume_ = false;
  SimulationChoices choices_;
  OutputOptions output_;
  ColorOption color_;
  SelectionOptions selection_;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> simulate_command() { return std::make_unique<Simulate>(); }

}  // namespace rigor::tool
