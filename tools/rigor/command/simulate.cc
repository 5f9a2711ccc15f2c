// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor simulate`: models in tests, and what came of it.

#include <algorithm>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include <rigor/author/simulation.h>
#include <rigor/read/load.h>
#include <rigor/report/simulation/simulation.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/rules/environment.h>
#include <rigor/simulate/engine/mujoco/mujoco_version.h>
#include <rigor/simulate/engine/ode/ode_version.h>
#include <rigor/simulate/run.h>
#include <rigor/view/image/picture.h>
#include <rigor/view/trace.h>

#include "command/command.h"
#include "model/model_file.h"
#include "model/render_model.h"
#include "option/rule_settings.h"
#include "option/search.h"
#include "option/simulation_options.h"
#include "output/output.h"
#include "output/progress.h"
#include "output/results_file.h"

namespace rigor::tool {
namespace {

enum SimulationFormat : std::size_t { kPretty, kJson, kJsonl, kJunit, kCsv, kHtml };

/// Of so many cases at a time there is a scene in memory. Each is written when it is done; its
/// trajectories stay only where a report besides the lines is asked for, which shows them.
constexpr std::size_t kChunk = 64;

/// On a page, each of some ten kilobytes.
constexpr std::size_t kMaxPictures = 64;

class Simulate final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(
        program, "simulate",
        "Simulate a model: drop it, drive it, sweep its joints, and get a verdict",
        {"rigor simulate my_robot",
         "rigor simulate my_robot --test settle,drive,turn --output html:run.html",
         "rigor simulate arm.urdf --command elbow=position:1.5 --duration 3 --format csv",
         "rigor simulate my_robot --engine both",
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
    const GuardedDisk disk = search_.disk(named_paths());
    Environment environment(disk, search_.paths());
    search_.allow(environment.workers);
    author::SimulationOptions options = choices_.options(disk);
    const RuleSettings settings(selection_, search_.config(), environment.registry);
    options.selection_for = [&settings](const std::string& path) {
      return settings.selection_of_command(path);
    };
    require_engines(options, environment);
    CountProgress progress("runs");
    options.progress = [&progress](std::size_t done, std::size_t of) { progress.at(done, of); };
    const std::vector<simulate::Case> grid = choices_.cases(options.plan);

    Sources sources;
    read::Workspace workspace(environment.resolver, sources);
    const author::Simulator simulator(environment, sources, workspace, options);
    const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    std::deque<read::Loaded> loaded;
    std::deque<author::PreparedModel> models;
    for (const std::string& path : files(environment, options.plan)) {
      const std::size_t number = files_++;
      if (is_of_another_shard(disk, path, grid)) continue;
      numbers_.push_back(number);
      loaded.push_back(read::load(reader, open_model(workspace, path)));
      if (loaded.back().root.format == model::Format::kMjcf) {
        throw UsageError(report::printable(path) + " is MJCF: simulate takes SDF and URDF");
      }
      const auto positions = joint_positions(loaded.back().root, choices_.joints());
      models.push_back(simulator.prepare(loaded.back(), positions));
    }
    if (files_ == 0) throw UsageError("there is no model to simulate");
    std::vector<const model::Root*> roots;
    for (const read::Loaded& file : loaded) roots.push_back(&file.root);
    // Another shard's model may be the one.
    if (loaded.size() == files_) require_model(options.scene.model, roots);
    return conclude(simulator, models, grid, targets, sources, disk.reach(), settings);
  }

 private:
  static void require_engines(const author::SimulationOptions& options,
                              const Environment& environment) {
    for (const simulate::EngineKind engine : options.engines) {
      const bool ode = engine == simulate::EngineKind::kOde;
      if (ode && simulate::ode_version().empty()) refuse_without("ODE", "simulate");
      if (!ode && simulate::mujoco_version().empty()) {
        refuse_without("MuJoCo", "simulate --engine mujoco");
      }
      simulate::SolverSettings settings;
      settings.engine = engine;
      settings.library = options.mujoco;
      const std::string problem = simulate::engine_problem(settings, environment.workers);
      if (!problem.empty()) throw UsageError(problem);
    }
  }

  std::vector<std::string> named_paths() const {
    std::vector<std::string> named = paths_;
    named.insert(named.end(), choices_.scenarios().begin(), choices_.scenarios().end());
    return named;
  }

  std::vector<std::string> files(const Environment& environment, const simulate::Plan& plan) {
    std::vector<std::string> named = paths_;
    if (named.empty()) named = choices_.models_of(plan);
    if (named.empty()) {
      throw UsageError("simulate needs a model; `rigor simulate --help` shows examples");
    }
    return model_paths(environment, named);
  }

  /// Whether no case of a file is this shard's, so that it need not be read: a thousand machines would each read
  /// all models. Of a folder the file that is simulated is not known yet.
  bool is_of_another_shard(const Disk& disk, const std::string& path,
                           const std::vector<simulate::Case>& grid) const {
    if (path.ends_with("model.config") || disk.kind(path) == PathKind::kFolder) return false;
    const Shard shard = choices_.shard();
    return std::none_of(grid.begin(), grid.end(),
                        [&](const simulate::Case& one) { return shard.has(path + ' ' + one.id); });
  }

  /// Every model at every point of the grid; without a model where another shard has all its cases.
  std::vector<author::SimulationCase> all_cases(const std::deque<author::PreparedModel>& models,
                                                const std::vector<simulate::Case>& grid) const {
    std::vector<author::SimulationCase> cases(files_ * grid.size());
    for (std::size_t i = 0; i < models.size(); ++i) {
      for (std::size_t k = 0; k < grid.size(); ++k) {
        author::SimulationCase& each = cases[numbers_[i] * grid.size() + k];
        each = {&models[i], grid[k]};
        each.one.index = numbers_[i] * grid.size() + k;
      }
    }
    return cases;
  }

  /// Those that are to be run: not done, and not another shard's.
  std::vector<author::SimulationCase> to_run(const std::vector<author::SimulationCase>& all,
                                             const ResultsFile& results) const {
    const Shard shard = choices_.shard();
    std::vector<author::SimulationCase> cases;
    for (const author::SimulationCase& each : all) {
      if (each.model == nullptr) continue;
      const bool ours = shard.has(each.model->loaded.file->path + ' ' + each.one.id);
      if (ours && !results.has(each.one.index)) cases.push_back(each);
    }
    return cases;
  }

  int conclude(const author::Simulator& simulator, const std::deque<author::PreparedModel>& models,
               const std::vector<simulate::Case>& grid, const std::vector<Target>& targets,
               const Sources& sources, const Reach& reach, const RuleSettings& settings) {
    const std::vector<author::SimulationCase> all = all_cases(models, grid);
    for (const author::PreparedModel& model : models) {
      refuse_problems(model, simulator.planned({&model, {}}));
    }
    for (const Target& target : targets) {
      if (target.format == kPretty) color_.of(target);  // refuses what is no color
    }
    ResultsFile results(results_file(targets));
    std::size_t failed_before = 0;
    if (resume_) {
      results.read([&](const KeptResult& kept, const std::string& where) {
        require_same(kept, where, all, simulator);
        if (kept.worst && settings.fails(kept.model, *kept.worst)) ++failed_before;
      });
    }
    const std::vector<author::SimulationCase> cases = to_run(all, results);
    results.open();  // now that nothing refuses any more: the lines of a run before are gone
    const bool only_lines = std::all_of(targets.begin(), targets.end(), [](const Target& target) {
      return target.format == kJsonl;
    });
    const bool prints_lines = std::any_of(targets.begin(), targets.end(), [](const Target& target) {
      return target.format == kJsonl && target.file.empty();
    });
    std::vector<author::SimulatedModel> done(cases.size());
    std::vector<std::string> lines(prints_lines ? cases.size() : 0);
    bool fails = failed_before > 0;
    for (std::size_t begin = 0; begin < cases.size(); begin += kChunk) {
      const auto first = cases.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto count = static_cast<std::ptrdiff_t>(std::min(kChunk, cases.size() - begin));
      simulator.run({first, first + count}, [&](std::size_t i, author::SimulatedModel result) {
        result.cases = all.size();
        result.diagnostics = withheld(result.diagnostics, sources, reach);
        fails = fails || settings.fails(result.path, result.diagnostics);
        std::string line = report::simulation_line(result, sources);
        results.add(result.one.index, line);
        if (prints_lines) lines[begin + i] = std::move(line);
        if (only_lines) keep_verdicts(result);
        done[begin + i] = std::move(result);
      });
    }
    results.finish();
    const bool page = std::any_of(targets.begin(), targets.end(),
                                  [](const Target& target) { return target.format == kHtml; });
    const report::SimulationReport report{done, sources,
                                          page ? pictures(done) : std::vector<std::string>()};
    for (const Target& target : targets) emit(target, report, lines);
    say(report::simulation_summary(report) + kept_words(results.kept(), failed_before));
    return fails ? kFindings : kClean;
  }

  /// "; 4 cases kept, 1 failing": of a run that was resumed.
  static std::string kept_words(std::size_t kept, std::size_t failing) {
    if (kept == 0) return {};
    const std::string words = "; " + report::counted(kept, "case") + " kept";
    return failing == 0 ? words : words + ", " + std::to_string(failing) + " failing";
  }

  /// Where results are kept line by line: the file of `--output jsonl:FILE`.
  std::string results_file(const std::vector<Target>& targets) const {
    std::string file;
    for (const Target& target : targets) {
      if (target.format != kJsonl || target.file.empty()) continue;
      if (!file.empty()) {
        throw UsageError("--output jsonl:FILE can be given once, not for " + file + " and for " +
                         target.file);
      }
      file = target.file;
    }
    if (resume_ && file.empty()) {
      throw UsageError("--resume needs --output jsonl:FILE, which it reads");
    }
    return file;
  }

  /// A line of another sweep must not pass for the case that has its number in this one.
  static void require_same(const KeptResult& kept, const std::string& where,
                           const std::vector<author::SimulationCase>& all,
                           const author::Simulator& simulator) {
    const std::string is = where + ": is of another run: of ";
    const std::string how = "; leave out --resume to start over, or name another file";
    if (kept.one.of != all.size()) {
      throw UsageError(is + std::to_string(kept.one.of) + " cases, not " +
                       std::to_string(all.size()) + how);
    }
    if (all[kept.one.index].model == nullptr) throw UsageError(is + "another shard" + how);
    const author::SimulationCase& ours = all[kept.one.index];
    std::vector<std::string> tests;
    // The budget may have left some out.
    for (const simulate::Scenario& each : simulator.planned(ours).scenarios) {
      const bool was_run =
          std::find(kept.tests.begin(), kept.tests.end(), each.name) != kept.tests.end();
      if (was_run || kept.tests.size() >= simulator.planned(ours).scenarios.size()) {
        tests.push_back(each.name);
      }
    }
    const std::string theirs_words = about(kept.model, kept.one.id, kept.tests);
    const std::string ours_words = about(ours.model->loaded.file->path, ours.one.id, tests);
    if (theirs_words == ours_words) return;
    throw UsageError(is + theirs_words + ", where this one has " + ours_words + how);
  }

  /// "cart.sdf [friction=0.2 seed=1] in settle, drive"; safe to print, and the same for a name and for
  /// what JSON has of it.
  static std::string about(const std::string& model, const std::string& id,
                           const std::vector<std::string>& tests) {
    std::string words = model + " [" + id + ']';
    const char* separator = " in ";
    for (const std::string& test : tests) {
      words += separator + test;
      separator = ", ";
    }
    return report::printable(words);
  }

  static void refuse_problems(const author::PreparedModel& model,
                              const simulate::Planned& planned) {
    if (planned.problems.empty()) return;
    const simulate::PlanProblem& problem = planned.problems.front();
    throw UsageError(
        model.loaded.file->path + ": there is no " + problem.what +
        did_you_mean(problem.name, {problem.candidates.begin(), problem.candidates.end()}));
  }

  /// Of the first models, each as it begins; none where none can be drawn.
  std::vector<std::string> pictures(const std::vector<author::SimulatedModel>& done) const {
    if (view::tracer().empty()) return {};
    const RealDisk disk;
    const Environment environment(disk, search_.paths());
    ModelPainter painter(disk, environment);
    std::map<std::string, std::string> known;
    std::vector<std::string> all;
    for (const author::SimulatedModel& model : done) {
      if (!known.contains(model.path) && known.size() == kMaxPictures) break;
      const auto [entry, is_new] = known.try_emplace(model.path);
      if (is_new) entry->second = picture(painter, model.path);
      all.push_back(entry->second);
    }
    return all;
  }

  std::string picture(ModelPainter& painter, const std::string& path) const {
    DrawnModel drawn =
        painter.draw(path, choices_.joints(), {view::Layer::kVisual, view::Layer::kGround});
    if (!drawn.problem.empty()) {
      drawn =
          painter.draw(path, choices_.joints(), {view::Layer::kCollision, view::Layer::kGround});
    }
    if (!drawn.problem.empty()) return {};
    return view::to_png(
        ModelPainter::picture(drawn.drawing, view::View::kPerspective,
                              {report::kSimulatedPictureWidth, report::kSimulatedPictureHeight}));
  }

  /// What the summary and the exit code are made of; the rest is in the lines.
  static void keep_verdicts(author::SimulatedModel& result) {
    result.scene = {};
    result.diagnostics = {};
    for (simulate::Run& run : result.simulation.runs) run = {};
  }

  static std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += line;
    return all;
  }

  void emit(const Target& target, const report::SimulationReport& report,
            const std::vector<std::string>& lines) const {
    switch (target.format) {
      case kPretty: return write(target, simulation_text(report, color_.of(target)));
      case kJson: return write(target, simulation_json(report));
      case kJsonl:
        if (target.file.empty()) write(target, joined(lines));
        return;
      case kJunit: return write(target, simulation_junit(report));
      case kCsv: return write(target, simulation_csv(report));
      default: return write(target, simulation_html(report));
    }
  }

  std::vector<std::string> paths_;
  std::size_t files_ = 0;             // of all shards
  std::vector<std::size_t> numbers_;  // of each model that was read, among them
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
