// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor report`: what a team puts on its CI.

#include <algorithm>
#include <charconv>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <rigor/author/simulation.h>
#include <rigor/report/team/report.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/report/validation.h>
#include <rigor/simulate/engine/ode/ode_version.h>
#include <rigor/simulate/test/tests.h>
#include <rigor/text/for_each_index.h>
#include <rigor/text/path.h>
#include <rigor/view/trace.h>

#include "command/command.h"
#include "command/report_results.h"
#include "model/report_models.h"
#include "option/baseline_options.h"
#include "option/search.h"
#include "output/atomic_file.h"
#include "output/output.h"
#include "output/progress.h"
#include "project/checking.h"

namespace rigor::tool {
namespace {

using report::TeamReportForm;

constexpr std::string_view kBudgetKinds[] = {"visual", "collision"};

/// So many models are in memory at a time, with their trajectories.
constexpr std::size_t kModelsAtATime = 64;

/// Whether a file is informed of as a model: what is broken has no format, but a name.
bool is_model(const rules::FileSummary& file) {
  if (!file.part_of.empty()) return false;
  if (file.format == model::Format::kSdf || file.format == model::Format::kUrdf ||
      file.format == model::Format::kMjcf) {
    return true;
  }
  const std::string ending = extension(file.path);
  return file.format == model::Format::kUnknown &&
         (ending == ".sdf" || ending == ".urdf" || ending == ".world" || ending == ".xacro");
}

std::uint64_t triangle_count(const std::string& option, const std::string& text) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error == std::errc() && end == text.data() + text.size()) return count;
  throw UsageError(option + " takes a number of triangles, not \"" + text + '"');
}

class Report final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app =
        add_command(program, "report", "A page about many models, for a team",
                    {"rigor report models worlds -o report.html", "rigor report . -o site/",
                     "rigor report my_robot -o report.html --test settle,drive",
                     "rigor report . -o report.html --no-simulate --budget visual=300000",
                     "rigor report results.sqlite -o site/"});
    app->add_option("paths", a_.paths,
                    "Files and folders (default: .); or one database that merge wrote")
        ->type_name("PATH");
    app->add_option("-o,--out", out_, "FILE.html, or FOLDER/ for a page a model")
        ->required()
        ->type_name("FILE");
    offer(
        app->add_option("--test", tests_,
                        "What is simulated: settle (the default), drop, drive, turn, brake, push, "
                        "joint-sweep, hold, tilt-table"),
        simulate::kTestNames)
        ->type_name("NAME,...")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_flag("--no-simulate", no_simulate_, "Do not simulate");
    app->add_flag("--no-pictures", no_pictures_, "Do not draw");
    app->add_option("--budget", budget_,
                    "Triangles that the meshes of a model may have: visual=N, collision=N")
        ->type_name("KIND=N,...")
        ->delimiter(',')
        ->allow_extra_args(false);
    a_.selection.declare(*app);
    a_.compat.declare(*app);
    baseline_.declare(*app);
    a_.files.declare(*app);
    app->add_option("-j,--jobs", a_.jobs, "Threads; 0, the default: as many as there are cores")
        ->type_name("N")
        ->check(CLI::Range(0, 1024));
    a_.cache.declare(*app);
    a_.search.declare(*app);
    return app;
  }

  int run() override {
    if (std::count(a_.paths.begin(), a_.paths.end(), "-") > 0) {
      throw UsageError("report reads files and folders, not stdin");
    }
    if (names_results(a_.paths)) return report_results(a_.paths.front(), out_);
    if (!no_simulate_ && simulate::ode_version().empty()) {
      refuse_without("ODE", "report without --no-simulate");
    }
    const TeamReportForm form = asked_form();
    report::TeamReportOptions options{form, a_.paths, budget()};
    if (options.paths.empty()) options.paths.emplace_back(".");
    author::SimulationOptions simulation = simulation_options();
    a_.search.config().open();
    const GuardedDisk disk = a_.search.unchecked_disk(a_.named());
    Checking checking(a_, disk);
    checking.refuse_bad_settings();
    simulation.selection_for = [&checking](const std::string& path) {
      rules::Selection selection = checking.settings().selection_of_command(path);
      selection.select.clear();  // what --select names are rules on files
      return selection;
    };
    baseline_.read(a_.search.config().disk(),
                   a_.search.config().baseline(checking.options().paths));

    Sources sources;
    const rules::ValidateResult result = report::grouped(
        baseline_.apply(checking.environment(), checking.options(), checking.run(sources)),
        report::GroupScope::kFile);
    report::TeamReport report({result, sources, checking.environment().registry}, options);
    ModelGatherer gatherer(checking, sources);
    const author::Simulator simulator(checking.environment(), sources, gatherer.workspace(),
                                      simulation);
    const bool fails = add_models(result, gatherer, simulator, checking.settings(), report);
    write_report(std::move(report).files());
    conclude(result);
    const int code = checking.exit_code(result);
    return code == kClean && (fails || baseline_.fails()) ? kFindings : code;
  }

 private:
  TeamReportForm asked_form() const {
    const std::string ending = extension(out_);
    if (ending == ".html" || ending == ".htm") return TeamReportForm::kOneFile;
    if (out_.ends_with('/') || std::filesystem::is_directory(out_)) return TeamReportForm::kFolder;
    throw UsageError("-o " + out_ + ": a report is FILE.html, or FOLDER/ with a slash at its end");
  }

  report::TriangleBudget budget() const {
    report::TriangleBudget budget;
    for (const std::string& text : budget_) {
      const auto [kind, count] = split_assignment("--budget", text);
      const bool visual = choice("--budget kind", kind, kBudgetKinds) == 0;
      (visual ? budget.visual : budget.collision) = triangle_count("--budget", count);
    }
    return budget;
  }

  author::SimulationOptions simulation_options() const {
    author::SimulationOptions options;
    for (const std::string& test : tests_) choice("test", test, simulate::kTestNames);
    options.plan.tests = tests_.empty() ? std::vector<std::string>{"settle"} : tests_;
    options.jobs = a_.jobs > 0 ? a_.jobs : std::max(1U, std::thread::hardware_concurrency());
    return options;
  }

  Pictures pictures() const {
    if (no_pictures_) return Pictures::kNone;
    if (!view::tracer().empty()) return Pictures::kDraw;
    say("rigor: no images: Embree is not installed");
    return Pictures::kNone;
  }

  /// Whether a simulation or a budget fails.
  bool add_models(const rules::ValidateResult& result, ModelGatherer& gatherer,
                  const author::Simulator& simulator, const RuleSettings& settings,
                  report::TeamReport& report) const {
    std::vector<std::size_t> files;
    for (std::size_t i = 0; i < result.files.size(); ++i) {
      const rules::FileSummary& file = result.files[i];
      if (!is_model(file)) continue;
      files.push_back(i);
    }
    const Pictures drawn = pictures();
    CountProgress progress("models");
    bool fails = false;
    for (std::size_t begin = 0; begin < files.size(); begin += kModelsAtATime) {
      const std::size_t count = std::min(kModelsAtATime, files.size() - begin);
      std::vector<GatheredModel> models(count);
      for_each_index(count, gatherer.turns(), 1, [&](std::size_t i) {
        const std::size_t file = files[begin + i];
        models[i] = gatherer.gather(result.files[file].path, drawn);
        models[i].told.file = file;
      });
      const std::vector<author::SimulatedModel> simulated = simulate(simulator, models);
      for (const GatheredModel& model : models) {
        const std::string& path = result.files[model.told.file].path;
        const author::SimulatedModel* simulation = model.told.simulation;
        fails = fails || (simulation != nullptr && settings.fails(path, simulation->diagnostics));
        fails = fails || (report::over_budget(model.told, budget()) &&
                          fail_on_level(settings.said(path).fail_on.value));
        report.add(model.told);
      }
      progress.at(begin + count, files.size());
    }
    return fails;
  }

  /// Each model is given its own of the results, which it refers to.
  std::vector<author::SimulatedModel> simulate(const author::Simulator& simulator,
                                               std::vector<GatheredModel>& models) const {
    std::deque<author::PreparedModel> prepared;
    std::vector<author::SimulationCase> cases;
    std::vector<GatheredModel*> of_case;
    for (GatheredModel& model : models) {
      if (no_simulate_) continue;
      if (!model.whole()) {
        model.told.not_simulated = "it could not be read whole";
        continue;
      }
      // A light, an actor: nothing is wrong with them.
      if (model.loaded.root.links.empty()) {
        model.told.not_simulated = "it has no links";
        continue;
      }
      // A sensor that is a part of robots: it would fall through the ground, which says nothing of it.
      if (model.loaded.root.collisions.empty()) {
        model.told.not_simulated = "it has no collisions";
        continue;
      }
      prepared.push_back(simulator.prepare(model.loaded, {}));
      cases.push_back({&prepared.back(), {}});
      of_case.push_back(&model);
    }
    std::vector<author::SimulatedModel> results = simulator.run(cases);
    for (std::size_t i = 0; i < results.size(); ++i) of_case[i]->told.simulation = &results[i];
    return results;
  }

  void write_report(const std::vector<report::ReportFile>& files) const {
    std::error_code error;
    if (out_.ends_with('/')) std::filesystem::create_directories(out_, error);
    if (error) throw UsageError(out_ + ": cannot be created: " + error.message());
    for (const report::ReportFile& file : files) {
      if (file.path.empty()) {
        replace_file(out_, file.bytes);
        continue;
      }
      put_file(out_, file.path, file.bytes);
    }
  }

  void conclude(const rules::ValidateResult& result) const {
    for (const std::string& argument : result.unusable) {
      say("rigor: " + report::printable(argument));
    }
    say(report::summary(result));
    baseline_.conclude();
  }

  CheckArguments a_;
  BaselineOptions baseline_;
  std::string out_;
  std::vector<std::string> tests_;
  std::vector<std::string> budget_;
  bool no_simulate_ = false;
  bool no_pictures_ = false;
};

}  // namespace

std::unique_ptr<Command> report_command() { return std::make_unique<Report>(); }

}  // namespace rigor::tool
