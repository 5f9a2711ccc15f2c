// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A simulation as a user asks for it: a model file made into a scene, run in tests, and told in findings
// whose help says what of the model is behind them.
//
//   const Simulator simulator(environment, sources, workspace, options);
//   const PreparedModel model = simulator.prepare(loaded, {});
//   for (const SimulatedModel& result : simulator.run({{&model, {}}})) print(result.diagnostics);

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/simulate/plan.h>
#include <rigor/simulate/scene/build.h>
#include <rigor/simulate/simulate.h>
#include <rigor/simulate/sweep.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::author {

/// What the command line says of the solver, in place of what the model's world does.
struct SolverChoice {
  std::optional<double> step;  ///< s
  std::optional<simulate::Solver> solver;
  std::optional<int> iterations;
  std::optional<model::Vector3> gravity;  ///< m/s²
};

struct SimulationOptions {
  rules::Selection selection;  ///< when it selects nothing, the category `simulate`
  /// That of the model at a path, where models differ; `selection` is for all when empty.
  std::function<rules::Selection(const std::string& path)> selection_for;
  simulate::SceneOptions scene;
  simulate::Plan plan;
  SolverChoice solver;
  std::vector<simulate::EngineKind> engines{simulate::EngineKind::kOde};
  std::string mujoco;  ///< the path of MuJoCo's library; empty for the installed one
  simulate::Confirm confirm = simulate::Confirm::kFailures;
  unsigned jobs = 1;
  double budget = simulate::kInfinity;  ///< s of CPU time, a model and case
  std::function<void(std::size_t, std::size_t)> progress;
};

/// A model that was made into a scene, or could not be.
struct PreparedModel {
  const read::Loaded& loaded;
  simulate::SceneResult made;
  simulate::Facts causes;
  simulate::DriveTrain wheels;
  std::string note;            ///< of the pose that its legs begin in, where one was chosen for it
  rules::Selection selection;  ///< which rules say what its runs show
  simulate::Facts remarks =
      {};  ///< what is to be known of each of its runs: no motor holds its joints
};

struct SimulationCase {
  const PreparedModel* model = nullptr;
  simulate::Case one;
};

struct SimulatedModel {
  std::string path;
  simulate::Case one;
  std::size_t cases = 1;  ///< of which it is one
  simulate::Scene scene;
  simulate::Simulation simulation;
  std::vector<std::string> left_out;            ///< tests that make no sense for the model, and why
  std::vector<std::string> notes;               ///< what was chosen for the user, and why
  simulate::Facts remarks;                      ///< how it was judged, where that is a warning
  std::vector<simulate::PlanProblem> problems;  ///< names of the plan that are nothing in the model
  bool blocked = false;                         ///< it could not be simulated: the findings say why
  Diagnostics diagnostics;

  /// Whether all that was asked for makes no sense for the model. The verdict is `pass` then.
  bool untested() const { return !blocked && simulation.runs.empty() && !left_out.empty(); }

  simulate::Verdict verdict() const {
    return blocked ? simulate::Verdict::kInvalid : simulation.verdict;
  }
};

class Simulator {
 public:
  /// All three outlive it.
  Simulator(const Environment& environment, const Sources& sources, read::Workspace& workspace,
            SimulationOptions options);

  /// `loaded` outlives the result. `positions`: of joints, that a run begins with.
  PreparedModel prepare(const read::Loaded& loaded, const model::JointPositions& positions) const;

  /// In the order of the cases, whatever the number of jobs.
  std::vector<SimulatedModel> run(const std::vector<SimulationCase>& cases) const;

  /// Hands each over, with its place among the cases, as soon as it is done.
  void run(const std::vector<SimulationCase>& cases,
           const std::function<void(std::size_t, SimulatedModel)>& done) const;

  /// What would be run, and names of the plan that are nothing in the model, without running it.
  simulate::Planned planned(const SimulationCase& one) const;

 private:
  void take_stand_pose(const read::Loaded& loaded, PreparedModel& model) const;
  void advise_inertias(const read::Loaded& loaded, simulate::Facts& causes) const;
  simulate::Planned planned_in(const simulate::Scene& scene, const PreparedModel& model) const;
  SimulatedModel start(const SimulationCase& one) const;
  Diagnostics told(const SimulationCase& one, const simulate::Facts& facts) const;
  void conclude(const SimulationCase& one, SimulatedModel& result) const;

  const Environment& environment_;
  const Sources& sources_;
  read::Workspace& workspace_;
  SimulationOptions options_;
};

}  // namespace rigor::author
