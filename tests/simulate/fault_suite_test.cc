// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Simulates the suite of testdata/simulate and counts how many of its planted faults come to light, and
// whether a sane model is ever accused. What is expected of each case stands in suite.tsv and comes from
// physics.
//
// Under sanitizers, where all takes ten times as long, only some rows run, and nothing is counted.

#include "simulate/fault_suite.h"
#include "support/workers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>

#include <rigor/simulate/advice/advice.h>
#include <rigor/simulate/engine/mujoco/mujoco_engine.h>
#include <rigor/simulate/simulate.h>
#include <rigor/simulate/test/tests.h>
#include <rigor/simulate/wheels.h>

namespace rigor {
namespace {

using simulate::Verdict;
using test::SuiteCase;

/// How many rows there are to each one that runs.
#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kSuiteStride = 8;
#elif defined(__has_feature)
constexpr std::size_t kSuiteStride = __has_feature(address_sanitizer) ? 8 : 1;
#else
constexpr std::size_t kSuiteStride = 1;
#endif

/// Failures of one row in so many are confirmed, which takes five times as long as to see them.
constexpr std::size_t kConfirmStride = 2;

struct SuiteOutcome {
  Verdict verdict = Verdict::kPass;  ///< in ODE
  std::optional<simulate::EngineComparison> comparison;
  simulate::Facts facts;
  std::string why_not;  ///< the test could not be made for the model
};

/// All that a row's run refers to.
struct SuiteRun {
  explicit SuiteRun(const SuiteCase& row)
      : model(row.file), made(simulate::build_scene(model.input(), {})) {
    if (made.blocked()) return;
    wheels = simulate::find_wheels(made.scene, {});
    causes = simulate::causes_in(made.scene, model.input(), wheels);
    test = simulate::make_test(row.test, made.scene, wheels);
  }

  SuiteOutcome before() const {
    return {.verdict = made.blocked() ? Verdict::kInvalid : Verdict::kPass,
            .facts = made.facts,
            .why_not = test.why_not};
  }

  test::SuiteModel model;
  simulate::SceneResult made;
  simulate::DriveTrain wheels;
  simulate::Facts causes;
  simulate::MadeTest test;
};

/// Both, where MuJoCo is installed: each row is run in each, and judged in ODE.
std::vector<simulate::EngineKind> suite_engines() {
  std::vector<simulate::EngineKind> engines{simulate::EngineKind::kOde};
  if (simulate::mujoco_problem({}).empty()) engines.push_back(simulate::EngineKind::kMujoco);
  return engines;
}

struct SuiteRow {
  SuiteCase row;
  SuiteOutcome outcome;
};

/// Rows that are to be simulated alike.
struct SuiteBatch {
  std::vector<simulate::Task> tasks;
  std::vector<std::size_t> row_of;

  void simulate_into(std::vector<SuiteRow>& rows, simulate::Confirm confirm) const {
    const auto done = simulate::simulate(tasks, {.confirm = confirm, .jobs = 2}, test::workers());
    for (std::size_t i = 0; i < done.size(); ++i) {
      SuiteOutcome& outcome = rows[row_of[i]].outcome;
      for (const simulate::EngineComparison& each : done[i].comparisons) {
        outcome.comparison = each;
      }
      for (const simulate::Run& run : done[i].runs) {
        if (run.engine != simulate::EngineKind::kOde) continue;
        outcome.verdict = simulate::worse(outcome.verdict, run.verdict);
        outcome.facts.insert(outcome.facts.end(), run.facts.begin(), run.facts.end());
      }
    }
  }
};

/// The sane rows, or the others, simulated.
std::vector<SuiteRow> simulated_rows(const std::function<bool(const SuiteCase&)>& wanted) {
  std::vector<SuiteRow> rows;
  std::vector<std::unique_ptr<SuiteRun>> runs;
  SuiteBatch confirmed, unconfirmed;
  std::size_t seen = 0;
  for (const SuiteCase& row : test::suite_cases()) {
    if (!wanted(row) || seen++ % kSuiteStride != 0) continue;
    const SuiteRun& run = *runs.emplace_back(std::make_unique<SuiteRun>(row));
    if (run.test.scenario) {
      SuiteBatch& batch = rows.size() % kConfirmStride == 0 ? confirmed : unconfirmed;
      const simulate::Scene& scene = run.made.scene;
      batch.tasks.push_back(
          {scene, run.causes, {*run.test.scenario}, run.wheels, scene.solver, suite_engines()});
      batch.row_of.push_back(rows.size());
    }
    rows.push_back({row, run.before()});
  }
  confirmed.simulate_into(rows, simulate::Confirm::kFailures);
  unconfirmed.simulate_into(rows, simulate::Confirm::kNo);
  return rows;
}

/// "robot/link base/collision box" as "robot::base::box".
std::string scoped_name_of(const std::string& subject) {
  std::string name;
  for (const std::string& part : test::suite_fields(subject, '/')) {
    if (!name.empty()) name += "::";
    const std::size_t kind = part.find(' ');
    name += kind == std::string::npos ? part : part.substr(kind + 1);
  }
  return name;
}

/// The element itself or a part of it.
bool is_or_is_in(const std::string& name, const std::string& element) {
  return name == element || name.compare(0, element.size() + 2, element + "::") == 0;
}

bool names_planted(const simulate::Facts& facts, const SuiteCase& row) {
  return std::any_of(facts.begin(), facts.end(), [&row](const simulate::Fact& fact) {
    return std::any_of(row.planted.begin(), row.planted.end(), [&fact](const std::string& element) {
      return is_or_is_in(scoped_name_of(fact.subject), element) || is_or_is_in(fact.name, element);
    });
  });
}

std::string suite_line(const SuiteCase& row, const SuiteOutcome& outcome) {
  std::string line = row.file + " " + row.test + ": expected " + row.expected + ", got " +
                     std::string(simulate::to_string(outcome.verdict)) + " (" + row.what + ")";
  if (!outcome.why_not.empty()) line += "; not run: " + outcome.why_not;
  for (const simulate::Fact& fact : outcome.facts) {
    line += "\n    kind " + std::to_string(static_cast<int>(fact.kind)) + " of '" + fact.subject +
            "': " + std::to_string(fact.value) + " against " + std::to_string(fact.limit) + " " +
            fact.name;
  }
  return line;
}

/// Whether two engines say the same of a row: it fails, or it does not.
bool fails_in(Verdict verdict) { return verdict == Verdict::kFail || verdict == Verdict::kInvalid; }

/// Holds the share of rows that fail in both engines, or in neither, against a least one.
void expect_agreement(const std::vector<SuiteRow>& rows, double least) {
  std::size_t same = 0;
  std::size_t all = 0;
  std::string others;
  for (const auto& [row, outcome] : rows) {
    const auto& pair = outcome.comparison;
    if (!pair) {  // refused before any engine
      EXPECT_EQ(outcome.verdict, Verdict::kInvalid) << row.file;
      continue;
    }
    const bool agrees = fails_in(pair->ode) == fails_in(pair->mujoco);
    ++all;
    same += agrees ? 1U : 0U;
    if (agrees && pair->differences.empty()) continue;
    others += row.file + " " + row.test + ": " + std::string(simulate::to_string(pair->ode)) +
              " in ODE, " + std::string(simulate::to_string(pair->mujoco)) + " in MuJoCo (" +
              row.what + ")\n";
    for (const std::string& words : pair->differences) others += "    " + words + "\n";
    others += "    explained by " + pair->explanation + "\n";
    EXPECT_NE(pair->explanation, "") << row.file;
  }
  testing::Test::RecordProperty("same", static_cast<int>(same));
  testing::Test::RecordProperty("rows", static_cast<int>(all));
  if (std::getenv("RIGOR_ENGINES_VERBOSE") != nullptr)
    std::printf("%zu of %zu\n%s", same, all, others.c_str());
  if (kSuiteStride > 1) return;  // too few to count
  EXPECT_GE(static_cast<double>(same), least * static_cast<double>(all)) << others;
}

TEST(FaultSuite, NoSaneModelFailsAndNoneIsCalledTheSolvers) {
  const auto rows = simulated_rows(&SuiteCase::sane);
  if (suite_engines().size() > 1) expect_agreement(rows, 0.95);
  for (const auto& [row, outcome] : rows) {
    EXPECT_TRUE(outcome.verdict == Verdict::kPass || outcome.verdict == Verdict::kWarn)
        << suite_line(row, outcome);
    EXPECT_EQ(outcome.why_not, "") << row.file;
  }
}

TEST(FaultSuite, MostPlantedFaultsFailAndNearlyAllAreNamed) {
  constexpr double kFailing = 0.80;
  constexpr double kNamed = 0.95;
  std::size_t failing = 0;
  std::size_t named = 0;
  std::string missed;
  const auto rows = simulated_rows([](const SuiteCase& row) { return !row.sane(); });
  if (suite_engines().size() > 1) expect_agreement(rows, 0.85);
  for (const auto& [row, outcome] : rows) {
    const bool invalid = outcome.verdict == Verdict::kInvalid;
    EXPECT_NE(outcome.verdict, Verdict::kSolver) << suite_line(row, outcome);
    EXPECT_EQ(invalid, row.expected == "invalid") << suite_line(row, outcome);
    const bool fails = invalid ? row.expected == "invalid" : outcome.verdict == Verdict::kFail;
    const bool told = fails || outcome.verdict == Verdict::kWarn;
    const bool names_it = told && names_planted(outcome.facts, row);
    failing += fails ? 1U : 0U;
    named += names_it ? 1U : 0U;
    if (!names_it || (!fails && row.expected != "warn")) missed += suite_line(row, outcome) + '\n';
  }
  if (kSuiteStride > 1) return;  // too few to count
  const auto all = static_cast<double>(rows.size());
  EXPECT_GE(static_cast<double>(failing), kFailing * all) << missed;
  EXPECT_GE(static_cast<double>(named), kNamed * all) << missed;
  RecordProperty("faults", static_cast<int>(rows.size()));
  RecordProperty("failing", static_cast<int>(failing));
  RecordProperty("named", static_cast<int>(named));
}

}  // namespace
}  // namespace rigor
