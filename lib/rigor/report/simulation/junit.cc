// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A suite for each model, a case for each run. Times are those of the simulation, so that the same run
// gives the same bytes.

#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/report/junit/document.h>
#include <rigor/report/number.h>
#include <rigor/report/simulation/run.h>
#include <rigor/report/simulation/simulation.h>
#include <rigor/report/terminal/concise.h>

namespace rigor::report {
namespace {

using author::SimulatedModel;
using simulate::Verdict;

bool failed(Verdict verdict) { return verdict == Verdict::kFail || verdict == Verdict::kInvalid; }

std::string measured(const simulate::Run& run) {
  std::string out;
  for (const simulate::Metric& metric : run.metrics) {
    out += fmt::format("{} = {}{}{} ({})\n", metric.id, number(metric.value),
                       metric.unit.empty() ? "" : " ", metric.unit, to_string(metric.verdict));
  }
  return out;
}

JunitCase run_case(const SimulatedModel& model, const simulate::Run& run, const Sources& sources) {
  JunitCase one{
      .class_name = case_name(model), .name = run_name(run), .time = number(run.record.end_time)};
  if (run.seed != 0) one.name += fmt::format(" (seed {})", run.seed);
  if (failed(run.verdict)) {
    one.outcome = JunitCase::Outcome::kFailure;
    one.message = one.type = to_string(run.verdict);
    one.details = concise(model.diagnostics, sources);
  }
  one.output = measured(run);
  return one;
}

JunitSuite model_suite(const SimulatedModel& model, const Sources& sources) {
  JunitSuite suite{.name = case_name(model)};
  if (model.blocked) {
    suite.cases.push_back({.class_name = case_name(model),
                           .name = "load",
                           .outcome = JunitCase::Outcome::kError,
                           .message = "invalid",
                           .type = "invalid",
                           .details = concise(model.diagnostics, sources)});
    return suite;
  }
  for (const simulate::Run& run : model.simulation.runs) {
    suite.cases.push_back(run_case(model, run, sources));
  }
  for (const std::string& why : model.left_out) {
    suite.cases.push_back({.class_name = case_name(model),
                           .name = why.substr(0, why.find(':')),
                           .outcome = JunitCase::Outcome::kSkipped,
                           .message = why});
  }
  return suite;
}

}  // namespace

std::string simulation_junit(const SimulationReport& report) {
  std::vector<JunitSuite> suites;
  for (const SimulatedModel& model : report.models) {
    suites.push_back(model_suite(model, report.sources));
  }
  return junit_document("rigor simulate", std::move(suites));
}

}  // namespace rigor::report
