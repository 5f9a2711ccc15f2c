// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// JUnit's XML as Jenkins and GitLab read it. Times are those of the simulation, so that the same run
// gives the same bytes.

#include <algorithm>

#include <fmt/core.h>

#include <rigor/report/concise.h>
#include <rigor/report/markup.h>
#include <rigor/report/number.h>
#include <rigor/report/simulation.h>

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

std::string test_case(const SimulatedModel& model, const simulate::Run& run,
                      const Sources& sources) {
  std::string name = run.test;
  if (run.seed != 0) name += fmt::format(" (seed {})", run.seed);
  std::string out = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{}\">\n",
                                escaped(model.path), escaped(name), number(run.record.end_time));
  if (failed(run.verdict)) {
    out += fmt::format("      <failure message=\"{}\" type=\"{}\">{}</failure>\n",
                       to_string(run.verdict), to_string(run.verdict),
                       escaped(concise(model.diagnostics, sources)));
  }
  out +=
      fmt::format("      <system-out>{}</system-out>\n    </testcase>\n", escaped(measured(run)));
  return out;
}

std::string suite(const SimulatedModel& model, const Sources& sources) {
  const auto& runs = model.simulation.runs;
  if (model.blocked) {
    return fmt::format(
        "  <testsuite name=\"{}\" tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\">\n"
        "    <testcase classname=\"{}\" name=\"load\">\n"
        "      <error message=\"invalid\" type=\"invalid\">{}</error>\n    </testcase>\n  "
        "</testsuite>\n",
        escaped(model.path), escaped(model.path), escaped(concise(model.diagnostics, sources)));
  }
  const auto failures = std::count_if(runs.begin(), runs.end(),
                                      [](const simulate::Run& run) { return failed(run.verdict); });
  std::string out = fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n",
      escaped(model.path), runs.size() + model.left_out.size(), failures, model.left_out.size());
  for (const simulate::Run& run : runs) out += test_case(model, run, sources);
  for (const std::string& why : model.left_out) {
    out += fmt::format(
        "    <testcase classname=\"{}\" name=\"{}\"><skipped message=\"{}\"/></testcase>\n",
        escaped(model.path), escaped(why.substr(0, why.find(':'))), escaped(why));
  }
  return out + "  </testsuite>\n";
}

}  // namespace

std::string simulation_junit(const SimulationReport& report) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"rigor simulate\">\n";
  for (const SimulatedModel& model : report.models) out += suite(model, report.sources);
  return out + "</testsuites>\n";
}

}  // namespace rigor::report
