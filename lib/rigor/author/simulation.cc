// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/simulation.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/author/inertia_advice.h>
#include <rigor/rules/runner.h>
#include <rigor/rules/suppression.h>
#include <rigor/simulate/advice/advice.h>
#include <rigor/simulate/pose/group_state.h>
#include <rigor/simulate/pose/stand_pose.h>
#include <rigor/simulate/scene/input.h>
#include <rigor/simulate/scene/unpowered.h>
#include <rigor/xml/document.h>

namespace rigor::author {
namespace {

using simulate::Facts;

/// The rules that refer to simulations, unless others are asked for.
rules::Selection simulation_rules(const SimulationOptions& options, const std::string& path) {
  rules::Selection selection =
      options.selection_for ? options.selection_for(path) : options.selection;
  if (selection.select.empty()) selection.select = {"simulate"};
  return selection;
}

bool is_cause(const simulate::Fact& fact) { return fact.kind >= simulate::FactKind::kCauseInertia; }

bool is_about_inertia(const simulate::Fact& cause) {
  return cause.kind == simulate::FactKind::kCauseInertia ||
         cause.kind == simulate::FactKind::kCauseInertiaNotWritten ||
         cause.kind == simulate::FactKind::kCauseDefaultInertia;
}

/// A fact of a run with the causes that follow it, and the tests that showed it.
struct ShownFact {
  simulate::Fact fact;
  std::vector<simulate::Fact> causes;
  std::vector<std::string> tests;
};

/// Whether its metrics show one fault: a joint that is too weak needs too much, stops short and is off its position.
bool is_one_fault_of_several_metrics(simulate::FactKind kind) {
  using enum simulate::FactKind;
  return kind == kJointOverloaded || kind == kTurnOff || kind == kCreeps || kind == kDriveDrifts;
}

bool is_same_fault(const simulate::Fact& a, const simulate::Fact& b) {
  if (a.kind != b.kind || a.subject != b.subject) return false;
  return a.name == b.name || is_one_fault_of_several_metrics(a.kind);
}

/// "settle", "settle and drop", "settle, drop and hold".
std::string in_a_row(const std::vector<std::string>& words) {
  std::string row;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) row += i + 1 == words.size() ? " and " : ", ";
    row += words[i];
  }
  return row;
}

/// What several runs show is said once, as the worst of them shows it, with the names of all.
Facts facts_of_all(const std::vector<simulate::Run>& runs) {
  std::vector<ShownFact> shown;
  for (const simulate::Run& run : runs) {
    ShownFact* last = nullptr;
    for (const simulate::Fact& fact : run.facts) {
      if (is_cause(fact) && last != nullptr) {
        const auto same = [&](const simulate::Fact& known) { return is_same_fault(known, fact); };
        if (std::none_of(last->causes.begin(), last->causes.end(), same)) {
          last->causes.push_back(fact);
        }
        continue;
      }
      auto known = std::find_if(shown.begin(), shown.end(), [&](const ShownFact& each) {
        return is_same_fault(each.fact, fact);
      });
      if (known == shown.end()) {
        shown.push_back({fact, {}, {}});
        known = shown.end() - 1;
      } else if (fact.severe && !known->fact.severe) {
        known->fact = fact;
      }
      const bool is_listed =
          std::find(known->tests.begin(), known->tests.end(), fact.test) != known->tests.end();
      if (!fact.test.empty() && !is_listed) known->tests.push_back(fact.test);
      last = is_cause(fact) ? nullptr : &*known;
    }
  }
  Facts facts;
  for (ShownFact& each : shown) {
    each.fact.test = in_a_row(each.tests);
    facts.push_back(std::move(each.fact));
    facts.insert(facts.end(), each.causes.begin(), each.causes.end());
  }
  return facts;
}

/// What is behind a finding: the places as labels, the words and each remedy once as help.
class Causes {
 public:
  void add(const Diagnostic& cause) {
    if (!cause.where.nowhere()) labels_.push_back({cause.where, cause.message});
    words_ += (words_.empty() ? "" : "; ") + cause.subject + ' ' + cause.message;
    if (remedies_.find(cause.help) == std::string::npos) remedies_ += "; " + cause.help;
  }

  void go_into(Diagnostic& shown) {
    shown.related.insert(shown.related.end(), labels_.begin(), labels_.end());
    if (words_.empty()) return;
    shown.help += (shown.help.empty() ? "" : "; ") + words_ + remedies_;
    *this = {};
  }

 private:
  std::vector<Label> labels_;
  std::string words_;
  std::string remedies_;
};

/// Of a file that consumers read no further than a fault in its text: nobody knows the rest.
std::optional<simulate::Fact> not_well_formed(const read::Loaded& loaded) {
  const auto& document = loaded.file->document;
  if (!document || document->complete()) return std::nullopt;
  simulate::Fact fact{.kind = simulate::FactKind::kUnreadable, .name = "it is not well-formed"};
  for (const xml::Fault& fault : document->faults()) {
    const bool is_read_no_further =
        xml::is_fatal(fault.kind) || fault.kind == xml::FaultKind::kDeclarationNotFirst;
    if (is_read_no_further && fact.where.nowhere()) fact.where = fault.where;
  }
  return fact;
}

/// What falls may have had its ground in a model that is not installed.
void name_skipped_includes(const model::Root& root, const Facts& as_read, Facts& shown) {
  std::string missing;
  for (const model::Include& include : root.includes) {
    const auto is_skipped = [&](const simulate::Fact& fact) {
      return fact.kind == simulate::FactKind::kElementIgnored && fact.name == "include" &&
             fact.where == include.uri.span;
    };
    if (std::none_of(as_read.begin(), as_read.end(), is_skipped)) continue;
    missing += (missing.empty() ? "" : ", ") + include.uri.value;
  }
  if (missing.empty()) return;
  for (simulate::Fact& fact : shown) {
    const bool falls = fact.kind == simulate::FactKind::kFalls ||
                       (fact.kind == simulate::FactKind::kSpawnedAbove && std::isinf(fact.value));
    if (falls)
      fact.help = "what would be below it may be in an include that was skipped: " + missing;
  }
}

bool is_listed(const Diagnostic& diagnostic, const std::vector<Diagnostic>& list) {
  return std::any_of(list.begin(), list.end(), [&](const Diagnostic& known) {
    return known.rule == diagnostic.rule && known.where == diagnostic.where &&
           known.message == diagnostic.message;
  });
}

}  // namespace

Simulator::Simulator(const Environment& environment, const Sources& sources,
                     read::Workspace& workspace, SimulationOptions options)
    : environment_(environment),
      sources_(sources),
      workspace_(workspace),
      options_(std::move(options)) {}

PreparedModel Simulator::prepare(const read::Loaded& loaded,
                                 const model::JointPositions& positions) const {
  rules::Selection selection = simulation_rules(options_, loaded.file->path);
  if (const std::optional<simulate::Fact> fault = not_well_formed(loaded)) {
    return {loaded, {{}, {*fault}}, {}, {}, {}, std::move(selection)};
  }
  const simulate::SceneFiles files(loaded, workspace_, environment_.resolver, environment_.workers,
                                   positions);
  using Root = simulate::SceneOptions::Root;
  const simulate::BaseOption base = options_.plan.base;
  const bool holds = base == simulate::BaseOption::kFixed || base == simulate::BaseOption::kHang;
  simulate::SceneOptions how = options_.scene;
  how.root = holds ? Root::kHeld : Root::kFree;
  PreparedModel model{
      loaded, simulate::build_scene(files.input(), how), {}, {}, {}, std::move(selection)};
  simulate::Scene& scene = model.made.scene;
  const SolverChoice& solver = options_.solver;
  if (solver.step) scene.solver.step = *solver.step;
  if (solver.solver) scene.solver.solver = *solver.solver;
  if (solver.iterations) scene.solver.iterations = *solver.iterations;
  if (solver.gravity) scene.gravity = *solver.gravity;
  scene.solver.library = options_.mujoco;
  if (model.made.blocked() || scene.bodies.empty()) return model;
  model.wheels = simulate::find_wheels(scene, options_.plan.wheels);
  const std::vector<std::uint32_t> unpowered = simulate::unpowered_joints(scene, model.wheels);
  if (!unpowered.empty()) {
    model.remarks.push_back(simulate::about_unpowered(scene, unpowered));
    scene = simulate::powered(std::move(scene), unpowered);
  }
  if (positions.empty()) take_stand_pose(loaded, model);
  model.causes = simulate::causes_in(scene, files.input(), model.wheels);
  advise_inertias(loaded, model.causes);
  return model;
}

/// A legged robot begins on its feet, where a pose for that is known or found.
void Simulator::take_stand_pose(const read::Loaded& loaded, PreparedModel& model) const {
  simulate::SceneResult& made = model.made;
  std::vector<simulate::GroupState> states;
  if (loaded.root.format == model::Format::kUrdf && made.scene.alone) {
    states = simulate::group_states(loaded.file->path, made.scene.name, workspace_);
  }
  const simulate::StandPose pose = simulate::find_stand_pose(made.scene, model.wheels, states);
  model.note = simulate::in_words(made.scene, pose);
  if (!pose.found()) return;
  made.scene = simulate::in_stand_pose(made.scene, pose);
  std::erase_if(made.facts, [](const simulate::Fact& fact) {
    return fact.kind == simulate::FactKind::kStartMoved;  // it begins elsewhere now
  });
}

/// The help of a cause in a link's inertia names `rigor inertia --write`. That is tried here: where it would write
/// nothing, or another file than the model's, the help is another.
void Simulator::advise_inertias(const read::Loaded& loaded, Facts& causes) const {
  InertiaAdvice advice(environment_, sources_, workspace_, loaded);
  for (simulate::Fact& cause : causes) {
    if (!is_about_inertia(cause)) continue;
    if (loaded.file->expanded || cause.help.empty()) cause.help = advice.help(cause.where);
  }
}

/// What can be said before anything is run.
SimulatedModel Simulator::start(const SimulationCase& one) const {
  SimulatedModel result;
  result.path = one.model->loaded.file->path;
  result.one = one.one;
  result.scene = one.model->made.scene;
  result.blocked = one.model->made.blocked();
  vary(result.scene, one.one);
  return result;
}

simulate::Planned Simulator::planned_in(const simulate::Scene& scene,
                                        const PreparedModel& model) const {
  if (model.made.blocked()) return {};
  simulate::Planned planned;
  if (!scene.bodies.empty()) {
    planned = scenarios_of(options_.plan, scene, model.wheels);
    for (simulate::Scenario& scenario : planned.scenarios) {
      if (options_.solver.solver) scenario.solver = options_.solver.solver;
    }
    return planned;
  }
  for (const std::string& test : options_.plan.tests) {
    if (test != "settle") planned.left_out.push_back(test + ": nothing moves");
  }
  return planned;
}

simulate::Planned Simulator::planned(const SimulationCase& one) const {
  return planned_in(start(one).scene, *one.model);
}

std::vector<SimulatedModel> Simulator::run(const std::vector<SimulationCase>& cases) const {
  std::vector<SimulatedModel> results(cases.size());
  run(cases, [&](std::size_t i, SimulatedModel result) { results[i] = std::move(result); });
  return results;
}

void Simulator::run(const std::vector<SimulationCase>& cases,
                    const std::function<void(std::size_t, SimulatedModel)>& done) const {
  std::vector<SimulatedModel> results;
  std::vector<simulate::Task> tasks;
  for (const SimulationCase& one : cases) results.push_back(start(one));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SimulatedModel& result = results[i];
    const PreparedModel& model = *cases[i].model;
    simulate::Planned planned = planned_in(result.scene, model);
    result.left_out = std::move(planned.left_out);
    result.notes = std::move(planned.notes);
    result.remarks = model.remarks;
    result.remarks.insert(result.remarks.end(), planned.facts.begin(), planned.facts.end());
    if (!model.note.empty()) result.notes.insert(result.notes.begin(), model.note);
    result.problems = std::move(planned.problems);
    tasks.push_back({result.scene, model.causes, std::move(planned.scenarios), model.wheels,
                     result.scene.solver, options_.engines});
  }
  simulate::simulate(tasks, {options_.confirm, options_.jobs, options_.budget, options_.progress},
                     environment_.workers, [&](std::size_t i, simulate::Simulation simulation) {
                       auto& left_out = results[i].left_out;
                       left_out.insert(left_out.end(), simulation.left_out.begin(),
                                       simulation.left_out.end());
                       results[i].simulation = std::move(simulation);
                       conclude(cases[i], results[i]);
                       done(i, std::move(results[i]));
                     });
}

/// A warning where a fact is not severe; causes go into the finding that they follow. One that follows
/// none is a finding of its own.
Diagnostics Simulator::told(const SimulationCase& one, const Facts& facts) const {
  if (facts.empty()) return {};
  Facts asked = facts;
  for (simulate::Fact& fact : asked) {
    if (is_cause(fact)) fact.test.clear();
  }
  const rules::Runner runner(environment_.registry, one.model->selection);
  const std::vector<Diagnostics> said =
      runner.run_each(environment_, sources_, one.model->loaded, asked);
  std::vector<Diagnostic> list;
  Causes causes;
  bool of_last = false;  // whether causes belong to the last finding of the list
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const simulate::Fact& fact = facts[i];
    if (!is_cause(fact)) {
      if (of_last) causes.go_into(list.back());
      of_last = false;
    }
    for (Diagnostic diagnostic : said[i].list()) {
      if (is_cause(fact) && of_last) {
        causes.add(diagnostic);
        continue;
      }
      // Several facts that nobody asked for may have one cause.
      if (is_cause(fact) && is_listed(diagnostic, list)) continue;
      of_last = !is_cause(fact);
      if (!fact.severe && diagnostic.severity == Severity::kError) {
        diagnostic.severity = Severity::kWarning;
      }
      list.push_back(std::move(diagnostic));
    }
  }
  if (of_last) causes.go_into(list.back());
  Diagnostics diagnostics;
  for (Diagnostic& diagnostic : list) diagnostics.add(std::move(diagnostic));
  return diagnostics;
}

void Simulator::conclude(const SimulationCase& one, SimulatedModel& result) const {
  if (!result.remarks.empty()) {
    simulate::Verdict& verdict = result.simulation.verdict;
    verdict = simulate::worse(verdict, simulate::Verdict::kWarn);
  }
  Facts shown = facts_of_all(result.simulation.runs);
  name_skipped_includes(one.model->loaded.root, one.model->made.facts, shown);
  result.diagnostics = told(one, one.model->made.facts);
  result.diagnostics.take(told(one, result.remarks));
  result.diagnostics.take(told(one, shown));
  // What the engine cannot take was not simulated: no comment makes that well.
  const auto& document = one.model->loaded.file->document;
  if (document && !result.blocked) {
    result.diagnostics = rules::Suppressions(*document).uncovered(std::move(result.diagnostics));
  }
  result.diagnostics.sort();
}

}  // namespace rigor::author
