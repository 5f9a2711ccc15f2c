// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/simulation_options.h"

#include <algorithm>
#include <charconv>
#include <thread>

#include <rigor/report/terminal/printable.h>
#include <rigor/simulate/test/tests.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "option/numbers.h"
#include "option/search.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kSolverNames[] = {"quick", "dantzig"};
constexpr std::string_view kEngineNames[] = {"ode", "mujoco", "both"};
constexpr std::string_view kProfileNames[] = {"rigor", "gazebo"};
constexpr std::string_view kMeshesNames[] = {"auto", "triangles", "hull"};
constexpr std::string_view kBaseNames[] = {"auto", "fixed", "free", "hang"};
constexpr std::string_view kCommandNames[] = {"effort", "velocity", "position"};

/// Scenario files are written by hand.
constexpr std::uint64_t kMaxScenarioBytes = std::uint64_t{1} << 20U;

/// How long a command is given when nobody says, s.
constexpr double kCommandDuration = 5;

/// s of CPU time a model: a wait that a person takes. And less than a run's least makes no sense.
constexpr double kBudget = 20;
constexpr double kMinBudget = 1;

/// A step command makes wheels spin: a second of ramp is what the tests take too.
constexpr double kCommandRamp = 1;

std::uint64_t whole_number(const std::string& option, const std::string& text, std::uint64_t least,
                           std::uint64_t most) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec == std::errc() && read.ptr == end && value >= least && value <= most) return value;
  throw UsageError(option + " takes a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most) + ", not \"" + text + '"');
}

/// "velocity:10"
std::pair<config::CommandKind, double> commanded_value(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    throw UsageError(
        "--command takes JOINT=velocity:NUMBER, position:NUMBER or effort:NUMBER, not \"" + text +
        '"');
  }
  constexpr config::CommandKind kKinds[] = {
      config::CommandKind::kEffort, config::CommandKind::kVelocity, config::CommandKind::kPosition};
  const std::size_t kind = choice("--command kind", text.substr(0, colon), kCommandNames);
  return {kKinds[kind], finite_number("--command", text.substr(colon + 1))};
}

/// "friction=0.2:1.0:9", or a single value.
simulate::GridAxis grid_axis(const std::string& text) {
  auto [name, range] = split_assignment("--grid", text);
  choice("--grid parameter", name, simulate::kParameters);
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin <= range.size()) {
    const std::size_t end = std::min(range.find(':', begin), range.size());
    parts.push_back(range.substr(begin, end - begin));
    begin = end + 1;
  }
  if (parts.size() != 1 && parts.size() != 3) {
    throw UsageError("--grid takes NAME=FROM:TO:COUNT, not \"" + text + '"');
  }
  simulate::GridAxis axis{std::move(name), finite_number("--grid", parts[0]), 0, 1};
  axis.to = axis.from;
  if (parts.size() == 3) {
    axis.to = finite_number("--grid", parts[1]);
    axis.count = static_cast<unsigned>(whole_number("--grid", parts[2], 1, simulate::kMaxCases));
  }
  for (const double value : {axis.from, axis.to}) {
    const std::string why = simulate::bad_value(axis.parameter, value);
    if (!why.empty()) throw UsageError("--grid " + text + ": " + axis.parameter + ' ' + why);
  }
  return axis;
}

config::ScenarioFile scenario_from(const Disk& disk, const std::string& path) {
  const ReadResult read = disk.read(path, kMaxScenarioBytes);
  if (!read.bytes) throw UsageError(path + ": " + read.problem);
  config::ScenarioFile file = config::read_scenario(path, *read.bytes);
  if (file.problems.empty()) return file;
  std::string all;
  for (const config::Problem& problem : file.problems) {
    all += (all.empty() ? "" : "\n") + path + ':' + std::to_string(problem.line) + ": " +
           problem.message;
  }
  throw UsageError(all);
}

}  // namespace

void SimulationChoices::declare(CLI::App& app) {
  std::vector<std::string_view> tests(simulate::kTestNames.begin(), simulate::kTestNames.end());
  tests.emplace_back("all");
  offer(app.add_option(
            "--test", tests_,
            "Tests to run: settle (the default), drop, drive, turn, brake, push, joint-sweep, "
            "hold, tilt-table, or all"),
        tests)
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--scenario", scenarios_, "A scenario of your own (see docs/scenarios.md)")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--command", commands_,
                 "Drive a joint: velocity:NUMBER, position:NUMBER or effort:NUMBER")
      ->type_name("JOINT=KIND:VALUE")
      ->allow_extra_args(false);
  app.add_option("--duration", duration_, "Of the commands, s (5)")->type_name("S");
  app.add_option("--ramp", ramp_, "Time to ramp up a command, s (1)")->type_name("S");
  app.add_option("--wheels", wheels_, "Joints that drive the robot; detected if not given")
      ->type_name("JOINT,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  offer(app.add_option(
            "--base", base_,
            "Base of a robot that nothing holds: auto (the default: free where it stands or "
            "rolls, else held), fixed to the ground, free, or hang, held without ground"),
        kBaseNames)
      ->type_name("HOW");
  app.add_option("--joint", joints_, "Initial position of a joint, rad or m")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_option("--model", model_, "Model to simulate, if the file has several")
      ->type_name("NAME");
  const std::string solver = "How it is computed";
  offer(app.add_option("--engine", engine_,
                       "Physics engine: ode (the default), mujoco, or both side by side"),
        kEngineNames)
      ->type_name("NAME")
      ->group(solver);
  app.add_option("--mujoco", mujoco_, "MuJoCo's library, if not the installed one")
      ->type_name("PATH")
      ->group(solver);
  app.add_option("--time-step", time_step_, "s (the world's, else 0.001)")
      ->type_name("S")
      ->group(solver);
  offer(app.add_option("--solver", solver_, "quick or dantzig")->type_name("NAME")->group(solver),
        kSolverNames);
  app.add_option("--iterations", iterations_, "Of the quick solver")->type_name("N")->group(solver);
  app.add_option("--gravity", gravity_, "m/s², in the world")
      ->type_name("X Y Z")
      ->expected(1, 3)
      ->group(solver);
  offer(app.add_option("--profile", profile_, "Solver settings: rigor (the default) or gazebo"),
        kProfileNames)
      ->type_name("NAME")
      ->group(solver);
  offer(app.add_option("--meshes", meshes_,
                       "Meshes collide as: auto (the default), triangles or hull"),
        kMeshesNames)
      ->type_name("HOW")
      ->group(solver);
  app.add_flag("--no-confirm", no_confirm_, "Do not confirm a failure with further runs")
      ->group(solver);
  const std::string many = "Many runs";
  app.add_option("--seed", seed_, "Of the solver's random order (0)")->type_name("N")->group(many);
  app.add_option("--seeds", seeds_, "Number of seeds to run with")->type_name("N")->group(many);
  app.add_option("--grid", grid_, "Vary friction, mass, inertia, gravity or time-step")
      ->type_name("NAME=FROM:TO:COUNT")
      ->allow_extra_args(false)
      ->group(many);
  app.add_option("-j,--jobs", jobs_, "Runs at a time (1); 0 means as many as there are cores")
      ->type_name("N")
      ->group(many);
  app.add_option(
         "--budget", budget_,
         "CPU time for each model, s (20): what it does not suffice for is left out, and said; "
         "0 means no limit")
      ->type_name("S")
      ->group(many);
  shard_.declare(app, "Only this part of the cases", many);
}

simulate::Plan SimulationChoices::plan(const Disk& disk) const {
  simulate::Plan plan;
  plan.wheels = wheels_;
  if (!base_.empty()) {
    constexpr simulate::BaseOption kBases[] = {
        simulate::BaseOption::kAuto, simulate::BaseOption::kFixed, simulate::BaseOption::kFree,
        simulate::BaseOption::kHang};
    plan.base = kBases[choice("--base value", base_, kBaseNames)];
  }
  const auto& known = simulate::kTestNames;
  for (const std::string& test : tests_) {
    if (test == "all") {
      plan.tests.insert(plan.tests.end(), known.begin(), known.end());
    } else {
      choice("test", test, known);
      plan.tests.push_back(test);
    }
  }
  for (const std::string& path : scenarios_) plan.scenarios.push_back(scenario_from(disk, path));
  if (commands_.empty() && !(duration_.empty() && ramp_.empty())) {
    throw UsageError("--duration and --ramp are of --command, and there is none");
  }
  if (!commands_.empty()) plan.scenarios.push_back(commanded());
  if (plan.tests.empty() && plan.scenarios.empty()) plan.tests.emplace_back("settle");
  return plan;
}

/// All commands at once, after a second of rest.
config::ScenarioFile SimulationChoices::commanded() const {
  config::ScenarioFile file;
  const double duration =
      duration_.empty() ? kCommandDuration : positive_number("--duration", duration_, "s");
  const double ramp = ramp_.empty() ? kCommandRamp : finite_number("--ramp", ramp_);
  if (ramp < 0) throw UsageError("--ramp " + ramp_ + ": must not be negative");
  config::ScenarioStep step{.name = "command", .until = duration};
  for (const std::string& text : commands_) {
    const auto [joint, what] = split_assignment("--command", text);
    const auto [kind, value] = commanded_value(what);
    step.commands.push_back(
        {.joints = {joint}, .kind = kind, .value = value, .ramp = std::min(ramp, duration)});
  }
  file.steps.push_back(std::move(step));
  return file;
}

author::SimulationOptions SimulationChoices::options(const Disk& disk) const {
  author::SimulationOptions options;
  options.plan = plan(disk);
  options.scene.model = model_;
  if (!profile_.empty() && choice("--profile value", profile_, kProfileNames) == 1) {
    options.scene.profile = simulate::SceneOptions::Profile::kGazebo;
  }
  if (!meshes_.empty()) {
    constexpr simulate::MeshAs kHow[] = {simulate::MeshAs::kAuto, simulate::MeshAs::kTriangles,
                                         simulate::MeshAs::kHull};
    options.scene.meshes = kHow[choice("--meshes value", meshes_, kMeshesNames)];
  }
  if (!time_step_.empty()) options.solver.step = positive_number("--time-step", time_step_, "s");
  if (!solver_.empty()) {
    constexpr simulate::Solver kSolvers[] = {simulate::Solver::kQuick, simulate::Solver::kDantzig};
    options.solver.solver = kSolvers[choice("--solver value", solver_, kSolverNames)];
  }
  if (!iterations_.empty()) {
    options.solver.iterations =
        static_cast<int>(whole_number("--iterations", iterations_, 1, 100'000));
  }
  // The command line goes before what a scenario says.
  for (config::ScenarioFile& file : options.plan.scenarios) {
    if (options.solver.step) file.time_step.reset();
    if (options.solver.solver) file.solver.reset();
    if (!gravity_.empty()) file.gravity.reset();
  }
  if (!gravity_.empty()) {
    const std::vector<double> numbers = finite_numbers("--gravity", gravity_);
    if (numbers.size() != 3) throw UsageError("--gravity takes three numbers, m/s²");
    options.solver.gravity = model::Vector3{numbers[0], numbers[1], numbers[2]};
  }
  if (!engine_.empty()) {
    using enum simulate::EngineKind;
    const std::vector<simulate::EngineKind> kEngines[] = {{kOde}, {kMujoco}, {kOde, kMujoco}};
    options.engines = kEngines[choice("--engine value", engine_, kEngineNames)];
  }
  options.mujoco = mujoco_;
  if (no_confirm_) options.confirm = simulate::Confirm::kNo;
  const double budget = budget_.empty() ? kBudget : finite_number("--budget", budget_);
  if (budget < 0) throw UsageError("--budget " + budget_ + ": must not be negative");
  if (budget > 0) options.budget = std::max(budget, kMinBudget);
  if (!jobs_.empty()) {
    options.jobs = static_cast<unsigned>(whole_number("--jobs", jobs_, 0, 1024));
    if (options.jobs == 0) options.jobs = std::max(1U, std::thread::hardware_concurrency());
  }
  return options;
}

std::vector<simulate::Case> SimulationChoices::cases(const simulate::Plan& plan) const {
  std::vector<simulate::GridAxis> grid;
  for (const std::string& text : grid_) grid.push_back(grid_axis(text));
  simulate::Seeds seeds;
  if (!seed_.empty()) seeds.first = whole_number("--seed", seed_, 0, UINT32_MAX);
  for (const config::ScenarioFile& file : plan.scenarios) {
    seeds.count = std::max(seeds.count, file.seeds.value_or(1));
  }
  if (!seeds_.empty()) {
    seeds.count = static_cast<unsigned>(whole_number("--seeds", seeds_, 1, simulate::kMaxCases));
  }
  std::vector<simulate::Case> cases = simulate::cases_of(grid, seeds);
  if (cases.empty()) {
    throw UsageError("--grid and --seeds make more than " + std::to_string(simulate::kMaxCases) +
                     " cases");
  }
  return cases;
}

std::vector<std::string> SimulationChoices::models_of(const simulate::Plan& plan) const {
  std::vector<std::string> models;
  for (const config::ScenarioFile& file : plan.scenarios) {
    if (file.model.empty()) continue;
    models.push_back(join_path(parent_path(file.path), file.model));
  }
  return models;
}

}  // namespace rigor::tool
